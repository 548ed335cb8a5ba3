#ifndef sandglass_particle_stage_particle_velocity_h
#define sandglass_particle_stage_particle_velocity_h

#include <sandglass/particle_stage/cell_kernel.h>

namespace Sandglass
{
  /**
   * Step 6 of Section 4.4, V_P += dt N(X_P) a, and in the same pass the sum of
   * the updated particles' momentum at the nodes, the right-hand side of step 7
   * (eq. 18).
   */
  template <typename Setting>
  void
  update_particle_velocity(ParticleCloud                          &cloud,
                           const CellGeometry<Setting::cell_type> &geometry,
                           const NodalField<dim>                  &acceleration,
                           const double                            time_step,
                           NodalField<dim>                        &momentum)
  {
    constexpr unsigned int n_nodes = Setting::nodes_per_cell;
    using Shape                    = CellShape<Setting::cell_type>;

    momentum.start_sum();
    for_each_filled_cell(
      cloud,
      geometry,
      [&](const unsigned int,
          const Shape &,
          const auto &nodes,
          const auto &particles) {
        const auto               accelerations = gather(acceleration, nodes);
        CellValues<dim, n_nodes> momenta{};
        for (auto &particle : particles)
          {
            double    *state = particle.get_properties().data();
            const auto values =
              Shape::shape_values(particle.get_reference_location());
            for (unsigned int d = 0; d < dim; ++d)
              {
                double particle_acceleration = 0.;
                for (unsigned int i = 0; i < n_nodes; ++i)
                  particle_acceleration += values[i] * accelerations[i][d];
                double &velocity = state[Property::velocity + d];
                velocity += time_step * particle_acceleration;
                for (unsigned int i = 0; i < n_nodes; ++i)
                  momenta[i][d] += values[i] * state[Property::mass] * velocity;
              }
          }
        scatter(momenta, nodes, momentum);
      });
    momentum.finish_sum();
  }
} // namespace Sandglass

#endif
