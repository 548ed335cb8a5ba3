// Friction of walls at nodes, with the springs that make it stick.

#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/particle_in_cell/contact.h>

#include <algorithm>

namespace Sandglass
{
  template <int dim>
  bool
  Contact<dim>::sticks_in_corner(const unsigned int    n,
                                 const double          mass,
                                 const Tensor<1, dim> &free_velocity) const
  {
    // In the plane an axis leaves room for one wall only.
    if constexpr (dim == 2)
      return cones[n].contain(-mass * free_velocity);
    Tensor<1, dim> along_planes = free_velocity;
    cancel_by_image(nodes[n], along_planes);
    return cones[n].contain(-mass * along_planes);
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

    return friction_of_wall(n,
                            s,
                            mass,
                            normal_impulse,
                            support.tangential(velocity) - support.velocity,
                            support.tangential(free_velocity) -
                              support.velocity);
  }



  template <int dim>
  Tensor<1, dim>
  Contact<dim>::friction_of_wall(const unsigned int    n,
                                 const unsigned int    s,
                                 const double          mass,
                                 const double          normal_impulse,
                                 const Tensor<1, dim> &slip,
                                 const Tensor<1, dim> &free_slip)
  {
    const auto [force, dissipated] =
      find_friction(n, s, mass, normal_impulse, slip, free_slip);
    sums.add_friction(n, s, time_step * force);
    dissipation += dissipated;
    work += time_step * (force * nodes[n].supports[s].velocity);
    return time_step / mass * force;
  }



  template <int dim>
  Tensor<1, dim>
  Contact<dim>::edge_reaction(const unsigned int    n,
                              const double          mass,
                              const bool            sticks,
                              const Tensor<1, dim> &impulse,
                              const Tensor<1, dim> &velocity,
                              const Tensor<1, dim> &free_velocity)
  {
    const auto               &supports = nodes[n].supports;
    const HeldDirections<dim> held(supports, holding[n]);
    const auto                coefficients = held.split(-impulse);

    // What each wall can rub, and how fast all of them move along the edge.
    std::array<double, dim> limits{};
    double                  limit   = 0.;
    unsigned int            n_walls = 0, wall = 0;
    Tensor<1, dim>          wall_velocity;
    for (unsigned int s = 0; s < supports.size(); ++s)
      if (contains(holding[n], s) && !supports[s].is_axis)
        {
          ++n_walls;
          wall = s;
          limits[s] =
            supports[s].friction_coefficient * std::max(0., coefficients[s]);
          limit += limits[s];
          wall_velocity += limits[s] * held.left_of(supports[s].velocity);
        }
    if (n_walls == 0)
      return {};
    if (n_walls == 1)
      {
        const Tensor<1, dim> along = held.left_of(supports[wall].velocity);
        return friction_of_wall(n,
                                wall,
                                mass,
                                std::max(0., coefficients[wall]),
                                held.left_of(velocity) - along,
                                held.left_of(free_velocity) - along);
      }

    if (limit > 0.)
      wall_velocity /= limit;
    const Tensor<1, dim> slip = held.left_of(free_velocity) - wall_velocity;
    const auto           friction =
      sticks ? Friction<dim>{-mass * held.left_of(free_velocity), false} :
                         coulomb(-mass * slip, limit);
    for (unsigned int s = 0; s < supports.size(); ++s)
      if (contains(holding[n], s) && !supports[s].is_axis)
        {
          const double share =
            limit > 0. ? limits[s] / limit : 1. / static_cast<double>(n_walls);
          sums.add_friction(n, s, share * friction.force);
          memories[n][s].is_sliding = friction.is_sliding;
        }
    const Tensor<1, dim> change = friction.force / mass;
    dissipation += std::max(0., -(friction.force * (slip + change)));
    work += friction.force * wall_velocity;
    return change;
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
            if (rubs_alone(n, s) && !is_corner(n))
              friction.stretch(memories[n][s],
                               along_support(nodes[n], s, difference),
                               nodes[n].supports[s].area,
                               time_step);
          }
      }
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



#define INSTANTIATE(dim)                                                                \
  template bool           Contact<dim>::sticks_in_corner(const unsigned int,            \
                                               const double,                  \
                                               const Tensor<1, dim> &) const; \
  template void           Contact<dim>::release_friction(const unsigned int,            \
                                               const unsigned int);           \
  template Tensor<1, dim> Contact<dim>::wall_reaction(const unsigned int,               \
                                                      const unsigned int,               \
                                                      const double,                     \
                                                      const double,                     \
                                                      const Tensor<1, dim> &,           \
                                                      const Tensor<1, dim> &);          \
  template Tensor<1, dim> Contact<dim>::edge_reaction(const unsigned int,               \
                                                      const double,                     \
                                                      const bool,                       \
                                                      const Tensor<1, dim> &,           \
                                                      const Tensor<1, dim> &,           \
                                                      const Tensor<1, dim> &);          \
  template void   Contact<dim>::stretch_friction(const NodalField<dim> &,               \
                                               const double);                         \
  template double Contact<dim>::friction_energy() const;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
