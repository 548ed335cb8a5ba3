#include <deal.II/base/mpi.h>

#include <sandglass/particle_stage/contact.h>

#include <map>

namespace Sandglass
{
  Contact::Contact(const Scene &scene, const WallParameters &parameters)
    : friction(parameters.friction_coefficient(),
               parameters.tangential_penalty,
               parameters.friction_update)
    , stops_velocity(parameters.normal_condition ==
                     WallParameters::NormalCondition::velocity)
    , communicator(scene.communicator)
  {
    for (const auto &boundary :
         find_boundary_nodes(scene.dof_handler, scene.formulation, parameters))
      {
        if (!scene.nodes->in_local_range(boundary.dof))
          continue;
        Node node{scene.nodes->global_to_local(boundary.dof), boundary, {}, 0};
        for (unsigned int s = 0; s < boundary.supports.size(); ++s)
          node.impulse[s] = {boundary.position,
                             boundary.supports[s].role,
                             boundary.supports[s].normal,
                             boundary.supports[s].tributary_area,
                             0.,
                             0.};
        nodes.push_back(node);
      }
    memories.resize(nodes.size());
  }



  void
  Contact::start_from(const std::vector<WallForce> &wall_forces)
  {
    // The static stage divides nodes between the ranks in its own way.
    using Record = std::array<double, 4>; // x, y, role, force
    std::vector<Record> own_records;
    for (const WallForce &force : wall_forces)
      own_records.push_back({{force.position[0],
                              force.position[1],
                              static_cast<double>(boundary_id(force.role)),
                              force.tangential_force}});
    std::map<std::array<double, 3>, double> force_at;
    for (const auto &records :
         Utilities::MPI::all_gather(communicator, own_records))
      for (const auto &[x, y, role, force] : records)
        force_at[{{x, y, role}}] = force;

    for (unsigned int n = 0; n < nodes.size(); ++n)
      for (unsigned int s = 0; s < nodes[n].boundary.supports.size(); ++s)
        {
          const BoundaryNode &node  = nodes[n].boundary;
          const auto          found = force_at.find(
            {{node.position[0],
                       node.position[1],
                       static_cast<double>(boundary_id(node.supports[s].role))}});
          if (found != force_at.end())
            memories[n][s] = {found->second, false};
        }
  }



  void
  Contact::apply(const NodalField<NodalSum::n_components> &sums,
                 const double                              time_step,
                 NodalField<dim>                          &acceleration)
  {
    summed_time += time_step;
    for (unsigned int n = 0; n < nodes.size(); ++n)
      {
        Node         &node = nodes[n];
        const double *sum  = sums.at(node.index);
        const double  mass = sum[NodalSum::mass];
        if (mass <= 0.)
          {
            memories[n]  = {};
            node.holding = 0;
            continue;
          }

        double        *node_acceleration = acceleration.at(node.index);
        Tensor<1, dim> velocity, free_velocity;
        for (unsigned int d = 0; d < dim; ++d)
          velocity[d] = sum[NodalSum::momentum + d] / mass;
        cancel_by_image(node.boundary, velocity);
        for (unsigned int d = 0; d < dim; ++d)
          free_velocity[d] = velocity[d] + time_step * node_acceleration[d];

        const Tensor<1, dim> approach =
          stops_velocity ? free_velocity : free_velocity - velocity;
        const unsigned int holding = holding_supports(node.boundary, approach);
        node.holding               = holding;
        Tensor<1, dim> end_velocity =
          free_velocity - approach +
          held_velocity(node.boundary, holding, approach);
        if (holding == 3 || node.boundary.is_fixed)
          record_normal_impulses(node, mass * (end_velocity - free_velocity));
        for (unsigned int s = 0; s < node.boundary.supports.size(); ++s)
          if (holding == 1u << s && !node.boundary.is_fixed)
            end_velocity +=
              wall_reaction(node,
                            memories[n][s],
                            s,
                            mass,
                            mass *
                              (approach * node.boundary.supports[s].normal),
                            velocity,
                            free_velocity,
                            time_step);
          else
            memories[n][s] = {};

        for (unsigned int d = 0; d < dim; ++d)
          node_acceleration[d] = (end_velocity[d] - velocity[d]) / time_step;
      }
  }



  Tensor<1, dim>
  Contact::wall_reaction(Node                 &node,
                         FrictionMemory       &memory,
                         const unsigned int    support_index,
                         const double          mass,
                         const double          normal_impulse,
                         const Tensor<1, dim> &velocity,
                         const Tensor<1, dim> &free_velocity,
                         const double          time_step)
  {
    const NodeSupport &support = node.boundary.supports[support_index];
    WallForce         &impulse = node.impulse[support_index];
    impulse.normal_force += normal_impulse;
    if (support.role == BoundaryRole::axis)
      return {};

    const Tensor<1, dim> tangent         = wall_tangent(support.normal);
    const double         free_tangential = free_velocity * tangent;
    const double         force           = friction.tangential_force(memory,
                                                   normal_impulse / time_step,
                                                   velocity * tangent,
                                                   free_tangential,
                                                   mass,
                                                   support.tributary_area,
                                                   time_step);
    impulse.tangential_force += force * time_step;
    const double change = time_step * force / mass;
    dissipation -= force * time_step * (free_tangential + change);
    return change * tangent;
  }



  void
  Contact::record_normal_impulses(Node                 &node,
                                  const Tensor<1, dim> &impulse) const
  {
    auto &records = node.impulse;
    if (node.boundary.supports.size() == 1)
      {
        records[0].normal_force -= impulse * records[0].normal;
        records[0].tangential_force +=
          impulse * wall_tangent(records[0].normal);
        return;
      }
    // impulse = -(a n_0 + b n_1)
    const Tensor<1, dim> &n0 = records[0].normal, &n1 = records[1].normal;
    const double          determinant = n0[0] * n1[1] - n0[1] * n1[0];
    records[0].normal_force -=
      (impulse[0] * n1[1] - impulse[1] * n1[0]) / determinant;
    records[1].normal_force -=
      (n0[0] * impulse[1] - n0[1] * impulse[0]) / determinant;
  }



  void
  Contact::constrain(NodalField<dim> &velocity) const
  {
    for (const Node &node : nodes)
      {
        double              *values = velocity.at(node.index);
        const Tensor<1, dim> free_velocity({values[0], values[1]});
        // A wall that presses lets a node move neither in nor out, or v^L's
        // noise would pump material off it. The other one lets nothing in.
        const auto pressed_velocity =
          held_velocity(node.boundary, node.holding, free_velocity);
        const unsigned int holding =
          node.holding | holding_supports(node.boundary, pressed_velocity);
        const auto held = held_velocity(node.boundary, holding, free_velocity);
        for (unsigned int d = 0; d < dim; ++d)
          values[d] = held[d];
      }
  }



  template <typename Holding>
  void
  Contact::release(NodalField<dim> &field, const Holding &holding) const
  {
    for (const Node &node : nodes)
      {
        double              *values = field.at(node.index);
        const Tensor<1, dim> released =
          held_velocity(node.boundary,
                        holding(node),
                        Tensor<1, dim>({values[0], values[1]}));
        for (unsigned int d = 0; d < dim; ++d)
          values[d] = released[d];
      }
  }



  void
  Contact::release_held(NodalField<dim> &field) const
  {
    release(field, [](const Node &node) { return node.holding; });
  }



  void
  Contact::release_always_held(NodalField<dim> &field) const
  {
    release(field, [](const Node &node) {
      unsigned int holding = 0;
      for (unsigned int s = 0; s < node.boundary.supports.size(); ++s)
        if (node.boundary.supports[s].role == BoundaryRole::axis)
          holding |= 1u << s;
      return holding;
    });
  }



  void
  Contact::add_forces(const NodalField<dim> &forces, const double time_step)
  {
    for (Node &node : nodes)
      if (node.holding != 0)
        {
          const double        *values = forces.at(node.index);
          const Tensor<1, dim> impulse(
            {time_step * values[0], time_step * values[1]});
          if (node.holding == 3 || node.boundary.is_fixed)
            record_normal_impulses(node, impulse);
          else
            for (const unsigned int s : {0u, 1u})
              if (node.holding == 1u << s)
                node.impulse[s].normal_force -=
                  impulse * node.boundary.supports[s].normal;
        }
  }



  unsigned int
  Contact::holding_supports(const BoundaryNode   &node,
                            const Tensor<1, dim> &velocity)
  {
    const auto holds = [&node](const unsigned int    s,
                               const Tensor<1, dim> &trial_velocity) {
      return node.supports[s].role == BoundaryRole::axis ||
             trial_velocity * node.supports[s].normal > 0.;
    };

    if (node.supports.size() == 1)
      return holds(0, velocity) ? 1 : 0;

    unsigned int n_held = 0;
    for (const unsigned int s : {0u, 1u})
      if (holds(s, velocity))
        {
          ++n_held;
          const unsigned int other = 1 - s;
          if (!holds(other, held_velocity(node, 1u << s, velocity)))
            return 1u << s;
        }
    return n_held == 0 ? 0 : 3;
  }



  Tensor<1, dim>
  Contact::held_velocity(const BoundaryNode   &node,
                         const unsigned int    holding,
                         const Tensor<1, dim> &velocity)
  {
    if (node.is_fixed || holding == 3)
      return {};
    Tensor<1, dim> held = velocity;
    for (unsigned int s = 0; s < node.supports.size(); ++s)
      if (holding == 1u << s)
        held -= (velocity * node.supports[s].normal) * node.supports[s].normal;
    return held;
  }



  std::vector<WallForce>
  Contact::take_mean_forces()
  {
    std::vector<WallForce> forces;
    for (auto &node : nodes)
      for (unsigned int s = 0; s < node.boundary.supports.size(); ++s)
        {
          WallForce &impulse = node.impulse[s];
          forces.push_back(impulse);
          if (summed_time > 0.)
            {
              forces.back().normal_force /= summed_time;
              forces.back().tangential_force /= summed_time;
            }
          impulse.normal_force     = 0.;
          impulse.tangential_force = 0.;
        }
    summed_time = 0.;
    return forces;
  }



  Contact::Sums
  Contact::sums() const
  {
    Sums sums{dissipation, summed_time, {}};
    for (const auto &node : nodes)
      sums.impulses.push_back({{node.impulse[0].normal_force,
                                node.impulse[0].tangential_force,
                                node.impulse[1].normal_force,
                                node.impulse[1].tangential_force}});
    return sums;
  }



  void
  Contact::set_sums(const Sums &sums)
  {
    AssertDimension(sums.impulses.size(), nodes.size());
    dissipation = sums.dissipation;
    summed_time = sums.time;
    for (unsigned int n = 0; n < nodes.size(); ++n)
      for (const unsigned int s : {0u, 1u})
        {
          nodes[n].impulse[s].normal_force     = sums.impulses[n][2 * s];
          nodes[n].impulse[s].tangential_force = sums.impulses[n][2 * s + 1];
        }
  }
} // namespace Sandglass
