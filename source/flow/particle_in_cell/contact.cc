#include <deal.II/base/mpi.h>

#include <sandglass/choices.h>
#include <sandglass/flow/particle_in_cell/contact.h>

#include <map>

namespace Sandglass
{
  namespace
  {
    /// Which support a force of the state at rest has come from: the wall's, or
    /// one with its direction. None if a wall has gone with its direction.
    template <int dim>
    int
    find_support(const BoundaryNode<dim> &node, const WallForce<dim> &force)
    {
      constexpr double same_direction = 1. - 1e-8;

      int    found   = -1;
      double nearest = -1.;
      for (unsigned int s = 0; s < node.supports.size(); ++s)
        {
          const Support<dim> &support = node.supports[s];
          const double        cosine  = support.normal * force.normal;
          bool                matches = cosine > same_direction;
          for (const WallShare &share : support.walls)
            matches = matches || share.wall == force.wall;
          if (matches && !support.is_axis && cosine > nearest)
            {
              found   = s;
              nearest = cosine;
            }
        }
      return found;
    }
  } // namespace



  template <int dim>
  Contact<dim>::Contact(const Scene<dim>     &scene,
                        const WallParameters &parameters)
    : HeldNodes<dim>(scene, parameters)
    , friction(parameters.tangential_penalty,
               parameters.penalty_limit,
               parameters.friction_update)
    , stops_velocity(parameters.normal_condition ==
                     WallParameters::NormalCondition::velocity)
    // Near an axis of revolution the critical step may fall within a few steps,
    // before it is looked at again; the impulse that stops the nodes there
    // brakes what starts to swing.
    , has_image(scene.formulation == Formulation::plane_strain)
    , scene(scene)
    , end_velocities(nodes.size())
    , memories(nodes.size())
    , sums(scene, nodes)
  {
    // With the paper's normal condition walls don't stop what comes to where
    // they meet.
    for (const BoundaryNode<dim> &node : nodes)
      cones.push_back(stops_velocity && !node.is_free ?
                        FrictionCones<dim>(node.supports) :
                        FrictionCones<dim>());
  }



  template <int dim>
  void
  Contact<dim>::start_from(const std::vector<WallForce<dim>> &wall_forces)
  {
    // The static stage divides nodes between the ranks in its own way.
    std::multimap<unsigned int, WallForce<dim>> forces_at;
    for (const auto &of_rank :
         Utilities::MPI::all_gather(scene.communicator, wall_forces))
      for (const WallForce<dim> &force : of_rank)
        forces_at.emplace(force.vertex, force);

    for (unsigned int n = 0; n < nodes.size(); ++n)
      {
        memories[n] = {};
        if (is_corner(n))
          continue;
        const auto [begin, end] = forces_at.equal_range(nodes[n].vertex);
        for (auto entry = begin; entry != end; ++entry)
          {
            const int s = find_support(nodes[n], entry->second);
            if (s >= 0)
              memories[n][s].force +=
                nodes[n].supports[s].tangential(entry->second.force);
          }
      }
  }



  template <int dim>
  void
  Contact<dim>::apply(const NodalSumField<dim> &nodal_sums,
                      const double              time_step,
                      NodalField<dim>          &acceleration)
  {
    this->time_step = time_step;
    summed_time += time_step;
    for (unsigned int n = 0; n < nodes.size(); ++n)
      {
        const BoundaryNode<dim> &node = nodes[n];
        const double            *sum  = nodal_sums.at(field_indices[n]);
        const double             mass = sum[NodalSum::mass];
        if (mass <= 0.)
          {
            for (unsigned int s = 0; s < node.supports.size(); ++s)
              release_friction(n, s);
            holding[n] = 0;
            continue;
          }

        double        *node_acceleration = acceleration.at(field_indices[n]);
        Tensor<1, dim> velocity, free_velocity;
        for (unsigned int d = 0; d < dim; ++d)
          velocity[d] = sum[NodalSum::momentum + d] / mass;
        if (has_image)
          cancel_by_image(node, velocity);
        for (unsigned int d = 0; d < dim; ++d)
          free_velocity[d] = velocity[d] + time_step * node_acceleration[d];

        const Tensor<1, dim> approach =
          stops_velocity ? free_velocity : free_velocity - velocity;
        holding[n] = is_corner(n) ?
                       hold_in_corner(n, mass, approach, free_velocity) :
                       holding_supports(node, approach);
        Tensor<1, dim> end_velocity =
          free_velocity - approach + held_velocity(node, holding[n], approach);
        if (n_supports(holding[n]) > 1 || node.is_fixed)
          record_normal_impulse(n, mass * (end_velocity - free_velocity));
        for (unsigned int s = 0; s < node.supports.size(); ++s)
          if (is_held_by_one(n, s))
            end_velocity +=
              wall_reaction(n,
                            s,
                            mass,
                            mass * (approach * node.supports[s].normal),
                            velocity,
                            free_velocity);
          else
            release_friction(n, s);

        end_velocities[n] = end_velocity;
        for (unsigned int d = 0; d < dim; ++d)
          node_acceleration[d] = (end_velocity[d] - velocity[d]) / time_step;
      }
  }



  template <int dim>
  SupportSet
  Contact<dim>::hold_in_corner(const unsigned int    n,
                               const double          mass,
                               const Tensor<1, dim> &approach,
                               const Tensor<1, dim> &free_velocity) const
  {
    return cones[n].contain(-mass * free_velocity) ?
             all_supports(nodes[n].supports.size()) :
             holding_supports(nodes[n], approach);
  }



  template <int dim>
  void
  Contact<dim>::release_friction(const unsigned int n, const unsigned int s)
  {
    FrictionMemory<dim> &memory = memories[n][s];
    dissipation +=
      friction.energy(memory, nodes[n].supports[s].area, time_step);
    memory = {};
  }



  template <int dim>
  FrictionStep<dim>
  Contact<dim>::find_friction(const unsigned int    n,
                              const unsigned int    s,
                              const double          mass,
                              const double          normal_impulse,
                              const Tensor<1, dim> &slip,
                              const Tensor<1, dim> &free_slip)
  {
    const Support<dim> &support = nodes[n].supports[s];
    const double        limit =
      support.friction_coefficient * (normal_impulse / time_step);
    if (!is_corner(n))
      return friction.step(
        memories[n][s], limit, slip, free_slip, mass, support.area, time_step);

    const auto without_spring = coulomb((-mass / time_step) * free_slip, limit);
    memories[n][s].is_sliding = without_spring.is_sliding;
    const Tensor<1, dim> end_slip =
      free_slip + time_step / mass * without_spring.force;
    return {without_spring.force,
            std::max(0., -time_step * (without_spring.force * end_slip))};
  }



  template <int dim>
  Tensor<1, dim>
  Contact<dim>::wall_reaction(const unsigned int    n,
                              const unsigned int    s,
                              const double          mass,
                              const double          normal_impulse,
                              const Tensor<1, dim> &velocity,
                              const Tensor<1, dim> &free_velocity)
  {
    const Support<dim> &support = nodes[n].supports[s];
    sums.add_normal(n, s, -normal_impulse * support.normal);
    if (support.is_axis)
      return {};

    const auto [force, dissipated] =
      find_friction(n,
                    s,
                    mass,
                    normal_impulse,
                    support.tangential(velocity) - support.velocity,
                    support.tangential(free_velocity) - support.velocity);
    sums.add_friction(n, s, time_step * force);
    dissipation += dissipated;
    work += time_step * (force * support.velocity);
    return time_step / mass * force;
  }



  template <int dim>
  void
  Contact<dim>::record_normal_impulse(const unsigned int    n,
                                      const Tensor<1, dim> &impulse)
  {
    const auto      &supports = nodes[n].supports;
    const SupportSet set =
      nodes[n].is_fixed ? all_supports(supports.size()) : holding[n];
    const HeldDirections<dim> held(supports, set);
    const auto                coefficients = held.split(impulse);
    // What no normal carries, a fixed node's supports have in equal parts.
    const Tensor<1, dim> rest =
      nodes[n].is_fixed ?
        held.left_of(impulse) / static_cast<double>(supports.size()) :
        Tensor<1, dim>();
    for (unsigned int s = 0; s < supports.size(); ++s)
      if (contains(set, s))
        sums.add_normal(n, s, coefficients[s] * supports[s].normal + rest);
  }



  template <int dim>
  void
  Contact<dim>::add_forces(const NodalField<dim> &forces,
                           const double           time_step)
  {
    for (unsigned int n = 0; n < nodes.size(); ++n)
      if (holding[n] != 0)
        record_normal_impulse(n,
                              time_step *
                                vector_at<dim>(forces, field_indices[n]));
  }



  template <int dim>
  void
  Contact<dim>::add_impulses(const std::vector<WallImpulse<dim>> &impulses)
  {
    for (const WallImpulse<dim> &at_wall : impulses)
      {
        sums.add(at_wall);
        dissipation -= at_wall.impulse * at_wall.slip;
        work += at_wall.impulse * at_wall.wall_velocity;
      }
  }



  template <int dim>
  void
  Contact<dim>::stretch_friction(const NodalField<dim> &mapped_velocity,
                                 const double           time_step)
  {
    for (unsigned int n = 0; n < nodes.size(); ++n)
      {
        const Tensor<1, dim> difference =
          vector_at<dim>(mapped_velocity, field_indices[n]) - end_velocities[n];
        for (unsigned int s = 0; s < nodes[n].supports.size(); ++s)
          {
            const Support<dim> &support = nodes[n].supports[s];
            if (is_held_by_one(n, s) && !support.is_axis && !is_corner(n))
              friction.stretch(memories[n][s],
                               support.tangential(difference),
                               support.area,
                               time_step);
          }
      }
  }



  template <int dim>
  void
  Contact<dim>::cancel_by_image(const BoundaryNode<dim> &node,
                                Tensor<1, dim>          &velocity)
  {
    for (const Support<dim> &support : node.supports)
      if (support.is_axis)
        velocity = support.tangential(velocity);
  }



  template <int dim>
  double
  Contact<dim>::friction_energy() const
  {
    double energy = 0.;
    for (unsigned int n = 0; n < nodes.size(); ++n)
      for (unsigned int s = 0; s < nodes[n].supports.size(); ++s)
        energy +=
          friction.energy(memories[n][s], nodes[n].supports[s].area, time_step);
    return energy;
  }



  template <int dim>
  WallArea
  Contact<dim>::wall_area() const
  {
    WallArea area{0., 0.};
    for (unsigned int n = 0; n < nodes.size(); ++n)
      for (unsigned int s = 0; s < nodes[n].supports.size(); ++s)
        {
          const Support<dim> &support = nodes[n].supports[s];
          if (!contains(holding[n], s) || support.is_axis)
            continue;
          area.touching += support.area;
          if (memories[n][s].is_sliding)
            area.sliding += support.area;
        }
    return area;
  }



#define INSTANTIATE(dim) template class Contact<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
