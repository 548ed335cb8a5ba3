#ifndef sandglass_particle_stage_particle_motion_h
#define sandglass_particle_stage_particle_motion_h

#include <sandglass/particle_stage/deformation.h>
#include <sandglass/particle_stage/relocation.h>
#include <sandglass/particle_stage/stress_update.h>
#include <sandglass/particle_stage/volumetric_average.h>

#include <vector>

namespace Sandglass
{
  /**
   * Steps 8 and 9 of Section 4.4 in one pass, since both need v^L in the
   * particle's cell: stress and density by `stress_update`, then the position
   * X_P += dt N(X_P) v^L. Particles whose new position lies outside their cell
   * (or too close to its edge for the nodes opposite to get any mass) are
   * appended to `strays`, their reference coordinates not yet updated. If
   * `is_averaged`, stressed particles take their cell's averaged change of
   * volume.
   */
  template <typename Setting, DensityUpdate density_update, bool is_averaged>
  class ParticleMotion
  {
  public:
    static constexpr unsigned int n_nodes = Setting::nodes_per_cell;
    using Shape                           = CellShape<Setting::cell_type>;
    using Geometry                        = CellGeometry<Setting::cell_type>;
    using VelocityOfCell                  = CellValues<dim, n_nodes>;

    static constexpr double smallest_distance =
      Relocation<Setting::cell_type>::margin;

    ParticleMotion(const StressUpdate<density_update> &stress_update,
                   const VolumetricAverage<Setting>   &volumetric_average,
                   const StressIntegration             integration,
                   const double                        time_step)
      : stress_update(stress_update)
      , volumetric_average(volumetric_average)
      , integration(integration)
      , time_step(time_step)
    {}

    /// @return the plastic work of the step in J.
    double
    compute(ParticleCloud         &cloud,
            const Geometry        &geometry,
            const NodalField<dim> &velocity,
            std::vector<Stray>    &strays) const
    {
      double dissipation = 0.;
      for_each_filled_cell(cloud,
                           geometry,
                           [&](const unsigned int cell,
                               const Shape       &shape,
                               const auto        &nodes,
                               const auto        &particles) {
                             move_in_cell(cell,
                                          shape,
                                          gather(velocity, nodes),
                                          particles,
                                          dissipation,
                                          strays);
                           });
      return dissipation;
    }

  private:
    template <typename ParticleRange>
    void
    move_in_cell(const unsigned int    cell,
                 const Shape          &shape,
                 const VelocityOfCell &velocities,
                 const ParticleRange  &particles,
                 double               &dissipation,
                 std::vector<Stray>   &strays) const
    {
      // On plane triangles all particles of a cell deform alike.
      constexpr bool is_uniform =
        Setting::has_constant_gradients && !Setting::has_hoop_strain;
      Deformations common;
      if constexpr (is_uniform)
        common = deformations(cell, shape, velocities, {}, {}, 1.);

      for (auto particle = particles.begin(); particle != particles.end();
           ++particle)
        {
          const Point<dim>    &reference = particle->get_reference_location();
          const Point<dim>     location  = particle->get_location();
          const auto           values    = Shape::shape_values(reference);
          const Tensor<1, dim> velocity  = interpolate(velocities, values);

          if constexpr (!is_uniform)
            common = deformations(
              cell, shape, velocities, reference, velocity, location[0]);
          double *state = particle->get_properties().data();
          update_stress(state,
                        is_averaged && volumetric_average.is_stressed(
                                         state[Property::density]) ?
                          common.averaged :
                          common.own,
                        dissipation);

          const Point<dim> new_location  = location + time_step * velocity;
          const Point<dim> new_reference = shape.to_reference(new_location);
          particle->set_location(new_location);
          if (Geometry::is_inside(new_reference, smallest_distance))
            particle->set_reference_location(new_reference);
          else
            strays.push_back({particle, cell});
        }
    }

    struct Deformation
    {
      SymmetricTensor4 elastic_stress;
      StressRotation   rotation;
      double           inverse_jacobian;
    };

    /// With the particle's own change of volume and with the cell's average.
    struct Deformations
    {
      Deformation own;
      Deformation averaged;
    };

    void
    update_stress(double            *state,
                  const Deformation &deformation,
                  double            &dissipation) const
    {
      stress_update(state,
                    deformation.elastic_stress,
                    deformation.rotation,
                    deformation.inverse_jacobian,
                    dissipation);
    }

    Deformation
    deformation(const DeformationIncrement &increment) const
    {
      return {stress_update.law.elasticity.stress(increment.strain),
              increment.rotation,
              1. / increment.jacobian};
    }

    Deformations
    deformations(const unsigned int    cell,
                 const Shape          &shape,
                 const VelocityOfCell &velocities,
                 const Point<dim>     &reference,
                 const Tensor<1, dim> &velocity,
                 const double          radius) const
    {
      const double hoop =
        Setting::has_hoop_strain ? time_step * velocity[0] / radius : 0.;
      const DeformationIncrement increment(
        time_step * gradient_of(velocities, shape.shape_gradients(reference)),
        hoop,
        integration);
      Deformations result;
      result.own = deformation(increment);
      if constexpr (is_averaged)
        result.averaged = deformation(increment.with_volume_change(
          time_step * volumetric_average.rate(cell)));
      return result;
    }

    const StressUpdate<density_update> &stress_update;
    const VolumetricAverage<Setting>   &volumetric_average;
    const StressIntegration             integration;
    const double                        time_step;
  };
} // namespace Sandglass

#endif
