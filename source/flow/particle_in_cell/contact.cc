#include <sandglass/choices.h>
#include <sandglass/flow/particle_in_cell/contact.h>

namespace Sandglass
{
  template <int dim>
  Contact<dim>::Contact(const Scene<dim> &scene, const WallParameters &parameters)
    : friction(parameters.friction_coefficient(),
               parameters.tangential_penalty,
               parameters.penalty_limit,
               parameters.friction_update)
    , stops_velocity(parameters.normal_condition ==
                     WallParameters::NormalCondition::velocity)
    // Near an axis of revolution the critical step may fall within a few steps,
    // before it is looked at again; the impulse that stops the nodes there
    // brakes what starts to swing.
    , has_image(scene.formulation == Formulation::plane_strain)
    , communicator(scene.communicator)
    , scene(scene)
  {
    for (const auto &boundary :
         find_boundary_nodes(scene.dof_handler, scene.formulation, parameters))
      {
        if (!scene.nodes->in_local_range(boundary.dof))
          continue;
        Node node{
          scene.nodes->global_to_local(boundary.dof), boundary, {}, 0, {}};
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



  template <int dim>
  void
  Contact<dim>::apply(const NodalSumField<dim> &sums,
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
        if (has_image)
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
          if (node.is_held_by_one(s))
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

        node.end_velocity = end_velocity;
        for (unsigned int d = 0; d < dim; ++d)
          node_acceleration[d] = (end_velocity[d] - velocity[d]) / time_step;
      }
  }



  template <int dim>
  Tensor<1, dim>
  Contact<dim>::wall_reaction(Node                 &node,
                         FrictionMemory       &memory,
                         const unsigned int    support_index,
                         const double          mass,
                         const double          normal_impulse,
                         const Tensor<1, dim> &velocity,
                         const Tensor<1, dim> &free_velocity,
                         const double          time_step)
  {
    const NodeSupport<dim> &support = node.boundary.supports[support_index];
    WallForce<dim>         &impulse = node.impulse[support_index];
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



  template <int dim>
  template <typename Holding>
  void
  Contact<dim>::release(NodalField<dim> &field, const Holding &holding) const
  {
    for (const Node &node : nodes)
      {
        double              *values = field.at(node.index);
        const Tensor<1, dim> value({values[0], values[1]});
        const Tensor<1, dim> released =
          held_velocity(node.boundary, holding(node, value), value);
        for (unsigned int d = 0; d < dim; ++d)
          values[d] = released[d];
      }
  }



  template <int dim>
  void
  Contact<dim>::constrain(NodalField<dim> &velocity) const
  {
    release(velocity,
            [](const Node &node, const Tensor<1, dim> &free_velocity) {
              // A wall that presses lets a node move neither in nor out, or
              // v^L's noise would pump material off it. The other one lets
              // nothing in.
              const auto pressed_velocity =
                held_velocity(node.boundary, node.holding, free_velocity);
              return node.holding |
                     holding_supports(node.boundary, pressed_velocity);
            });
  }



  template <int dim>
  void
  Contact<dim>::stretch_friction(const NodalField<dim> &mapped_velocity,
                            const double           time_step)
  {
    for (unsigned int n = 0; n < nodes.size(); ++n)
      {
        const Node          &node   = nodes[n];
        const double        *mapped = mapped_velocity.at(node.index);
        const Tensor<1, dim> difference =
          Tensor<1, dim>({mapped[0], mapped[1]}) - node.end_velocity;
        for (unsigned int s = 0; s < node.boundary.supports.size(); ++s)
          {
            const NodeSupport<dim> &support = node.boundary.supports[s];
            if (node.is_held_by_one(s) && support.role != BoundaryRole::axis)
              friction.stretch(memories[n][s],
                               difference * wall_tangent(support.normal),
                               support.tributary_area,
                               time_step);
          }
      }
  }



  template <int dim>
  void
  Contact<dim>::release_held(NodalField<dim> &field) const
  {
    release(field, [](const Node &node, const Tensor<1, dim> &) {
      return node.holding;
    });
  }



  template <int dim>
  void
  Contact<dim>::release_always_held(NodalField<dim> &field) const
  {
    release(field, [](const Node &node, const Tensor<1, dim> &) {
      unsigned int holding = 0;
      for (unsigned int s = 0; s < node.boundary.supports.size(); ++s)
        if (node.boundary.supports[s].role == BoundaryRole::axis)
          holding |= 1u << s;
      return holding;
    });
  }



  template <int dim>
  unsigned int
  Contact<dim>::holding_supports(const BoundaryNode<dim>   &node,
                            const Tensor<1, dim> &velocity)
  {
    const auto holds = [&node](const unsigned int    s,
                               const Tensor<1, dim> &trial_velocity) {
      return node.supports[s].role == BoundaryRole::axis ||
             trial_velocity * node.supports[s].normal > 0.;
    };

    if (node.is_free)
      return 0;
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



  template <int dim>
  Tensor<1, dim>
  Contact<dim>::held_velocity(const BoundaryNode<dim>   &node,
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



#define INSTANTIATE(dim) \
  template class Contact<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
