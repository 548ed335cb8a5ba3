#ifndef sandglass_particle_stage_cell_deformation_h
#define sandglass_particle_stage_cell_deformation_h

#include <sandglass/particle_stage/cell_integration.h>
#include <sandglass/particle_stage/deformation.h>
#include <sandglass/particle_stage/stress_update.h>

namespace Sandglass
{
  /// The volumetric rate that a cell's stressed particles take on.
  struct AveragedRate
  {
    double rate;             ///< in 1/s
    double smallest_density; ///< of stressed particles, in kg/m^3
  };

  /**
   * What the velocity v^L of a cell's nodes does in one step to the particles
   * in the cell. Where all of them deform alike, this is found once.
   *
   * @tparam is_averaged  whether stressed particles take on an AveragedRate
   *                      instead of their own volumetric rate.
   */
  template <typename Setting, bool is_averaged>
  class CellDeformation
  {
  public:
    static constexpr unsigned int n_nodes = Setting::nodes_per_cell;
    using Shape                           = CellShape<Setting::cell_type>;
    using OfNodes                         = CellValues<dim, n_nodes>;
    using RateChange = typename CellIntegration<Setting>::RateChange;

    /**
     * `shape`, `velocities` and `elasticity` have to live as long as this
     * object.
     *
     * @param velocities  of the cell's nodes, in m/s.
     * @param change      what all particles' rates differ by from v^L's.
     * @param averaged    if `is_averaged`.
     */
    CellDeformation(const Shape            &shape,
                    const OfNodes          &velocities,
                    const RateChange       &change,
                    const AveragedRate     &averaged,
                    const Elasticity       &elasticity,
                    const StressIntegration integration,
                    const double            time_step)
      : shape(shape)
      , velocities(velocities)
      , change(change)
      , averaged(averaged)
      , elasticity(elasticity)
      , integration(integration)
      , time_step(time_step)
    {
      if constexpr (Setting::has_uniform_strain)
        {
          const auto increment = increment_of(Pair<double>(), 0.);
          uniform.own          = deformation(increment);
          if constexpr (is_averaged)
            {
              const double difference =
                time_step * averaged.rate - increment.volume_change();
              uniform.pressure_rise = -elasticity.bulk_modulus() * difference;
              uniform.averaged_inverse_jacobian =
                uniform.own.inverse_jacobian / (1. + difference);
            }
        }
    }

    /**
     * Of a block of particles.
     *
     * @param velocity  v^L at the particles, in m/s.
     */
    auto
    operator()(const ParticleState<Lanes> &state,
               const Pair<Lanes>          &velocity) const
    {
      if constexpr (Setting::has_uniform_strain)
        {
          if constexpr (is_averaged)
            return choose(state);
          else
            return uniform.own;
        }
      else
        {
          Lanes hoop_rate(0.);
          if constexpr (Setting::has_hoop_strain)
            hoop_rate = velocity[0] / state.location[0];
          auto increment = increment_of(state.reference, hoop_rate);
          if constexpr (is_averaged)
            increment.add_volume_change(
              select(is_stressed(state),
                     Lanes(time_step * averaged.rate) -
                       increment.volume_change(),
                     Lanes(0.)));
          return deformation(increment);
        }
    }

  private:
    /// Of all particles of a cell alike.
    struct Uniform
    {
      ParticleDeformation<double> own;
      /// With the averaged rate, which changes all normal stresses alike.
      double pressure_rise;
      double averaged_inverse_jacobian;
    };

    struct Nothing
    {};

    /// Of v^L with the change, in 1/s.
    template <typename Number>
    auto
    velocity_gradient(const Pair<Number> &reference) const
    {
      if constexpr (Setting::has_constant_gradients)
        return gradient_of(velocities, shape.shape_gradients(reference));
      else
        {
          auto gradient = shape.gradient_of(velocities, reference);
          for (unsigned int d = 0; d < dim; ++d)
            for (unsigned int e = 0; e < dim; ++e)
              gradient[d][e] += change.gradient[d][e];
          return gradient;
        }
    }

    template <typename Number>
    DeformationIncrement<Number>
    increment_of(const Pair<Number> &reference, const Number &hoop_rate) const
    {
      auto gradient = velocity_gradient(reference);
      for (auto &row : gradient)
        for (auto &entry : row)
          entry *= time_step;
      Number hoop(0.);
      if constexpr (Setting::has_hoop_strain)
        hoop = time_step * (hoop_rate + change.hoop);
      return {gradient, hoop, integration};
    }

    template <typename Number>
    ParticleDeformation<Number>
    deformation(const DeformationIncrement<Number> &increment) const
    {
      return {elasticity.stress(increment.strain),
              increment.rotation,
              Number(1.) / increment.jacobian};
    }

    auto
    is_stressed(const ParticleState<Lanes> &state) const
    {
      return state.density >= Lanes(averaged.smallest_density);
    }

    /// Of the two uniform ones, by whether each particle is stressed.
    ParticleDeformation<Lanes>
    choose(const ParticleState<Lanes> &state) const
    {
      const auto  takes_average = is_stressed(state);
      const Lanes pressure_rise =
        select(takes_average, Lanes(uniform.pressure_rise), Lanes(0.));
      ParticleDeformation<Lanes> chosen;
      for (unsigned int c = 0; c < 4; ++c)
        {
          chosen.elastic_stress[c] = Lanes(uniform.own.elastic_stress[c]);
          if (c != Component::xy)
            chosen.elastic_stress[c] -= pressure_rise;
        }
      chosen.rotation         = {uniform.own.rotation.cosine,
                                 uniform.own.rotation.sine};
      chosen.inverse_jacobian = select(takes_average,
                                       Lanes(uniform.averaged_inverse_jacobian),
                                       Lanes(uniform.own.inverse_jacobian));
      return chosen;
    }

    const Shape            &shape;
    const OfNodes          &velocities;
    const RateChange        change;
    const AveragedRate      averaged;
    const Elasticity       &elasticity;
    const StressIntegration integration;
    const double            time_step;

    std::conditional_t<Setting::has_uniform_strain, Uniform, Nothing> uniform;
  };
} // namespace Sandglass

#endif
