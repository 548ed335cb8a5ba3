#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/particle_in_cell/contact.h>

namespace Sandglass
{
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
    , has_image(scene.formulation != Formulation::axisymmetric)
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
        const bool sticks =
          is_corner(n) && sticks_in_corner(n, mass, free_velocity);
        holding[n] = sticks ? all_supports(node.supports.size()) :
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
          else if (!rubs_alone(n, s))
            release_friction(n, s);
        if (is_on_edge(n))
          end_velocity += edge_reaction(n,
                                        mass,
                                        sticks,
                                        mass * (end_velocity - free_velocity),
                                        velocity,
                                        end_velocity);

        end_velocities[n] = end_velocity;
        for (unsigned int d = 0; d < dim; ++d)
          node_acceleration[d] = (end_velocity[d] - velocity[d]) / time_step;
      }
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
  Contact<dim>::cancel_by_image(const BoundaryNode<dim> &node,
                                Tensor<1, dim>          &velocity)
  {
    for (const Support<dim> &support : node.supports)
      if (support.is_axis)
        velocity = support.tangential(velocity);
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
