#ifndef sandglass_flow_particle_in_cell_cell_deformation_h
#define sandglass_flow_particle_in_cell_cell_deformation_h

#include <sandglass/flow/particle_in_cell/cell_integration.h>
#include <sandglass/flow/particle_in_cell/is_dense.h>
#include <sandglass/flow/particle_in_cell/stress_update.h>

namespace Sandglass
{
  /// The volumetric rate that a cell's particles take on.
  struct AveragedRate
  {
    double rate;                 ///< of dense ones, in 1/s
    double separated_compaction; ///< of the others besides their own, in 1/s
    double smallest_density;     ///< of the dense ones, in kg/m^3
  };

  /**
   * What the velocity v^L of a cell's nodes does in one step to the particles
   * in the cell. Where all of them deform alike, this is found once, the law's
   * prediction included.
   *
   * @tparam is_averaged  whether dense particles take on an AveragedRate
   *                      instead of their own volumetric rate.
   */
  template <typename Setting, typename Law, bool is_averaged>
  class CellDeformation
  {
  public:
    static constexpr unsigned int n_nodes = Setting::nodes_per_cell;
    static constexpr int          dim     = Setting::dim;

    using Kinematics = typename Setting::Kinematics;
    using Shape      = typename Setting::Shape;
    using State      = ParticleState<typename Setting::Layout, Lanes>;
    using OfNodes    = CellValues<dim, n_nodes>;
    using RateChange = typename CellIntegration<Setting>::RateChange;
    template <typename Number>
    using Vector = typename Setting::template Vector<Number>;

    /**
     * `shape`, `velocities` and `law` have to live as long as this object.
     *
     * @param velocities  of the cell's nodes, in m/s.
     * @param change      by how much all particles' rates differ from v^L's.
     * @param averaged    used if `is_averaged`.
     */
    CellDeformation(const Shape            &shape,
                    const OfNodes          &velocities,
                    const RateChange       &change,
                    const AveragedRate     &averaged,
                    const Law              &law,
                    const StressIntegration integration,
                    const double            time_step)
      : shape(shape)
      , velocities(velocities)
      , change(change)
      , averaged(averaged)
      , law(law)
      , integration(integration)
      , time_step(time_step)
    {
      if constexpr (Setting::has_uniform_strain)
        {
          auto increment = increment_of(Vector<double>(), 0.);
          if constexpr (is_averaged)
            if (averaged.separated_compaction > 0.)
              increment.add_volume_change(-time_step *
                                          averaged.separated_compaction);
          uniform.own = deformation(increment);
          if constexpr (is_averaged)
            {
              increment.add_volume_change(time_step * averaged.rate -
                                          increment.volume_change());
              uniform.averaged = deformation(increment);
            }
        }
    }

    /**
     * The deformation of a block of particles.
     *
     * @param velocity  v^L at the particles, in m/s.
     */
    auto
    operator()(const State &state, const Vector<Lanes> &velocity) const
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
            {
              const Lanes own = increment.volume_change();
              increment.add_volume_change(
                select(is_dense(state, averaged.smallest_density),
                       Lanes(time_step * averaged.rate),
                       own - Lanes(time_step * averaged.separated_compaction)) -
                own);
            }
          return deformation(increment);
        }
    }

  private:
    template <typename Number>
    using Increment = typename Kinematics::template Increment<Number>;

    /// Gradient of v^L, the change included, in 1/s.
    template <typename Number>
    auto
    velocity_gradient(const Vector<Number> &reference) const
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
    Increment<Number>
    increment_of(const Vector<Number> &reference, const Number &hoop_rate) const
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
    using Deformation = ParticleDeformation<
      decltype(std::declval<Law>().predict(std::declval<Increment<Number>>(),
                                           0.)),
      decltype(std::declval<Increment<Number>>().rotation),
      Number>;

    template <typename Number>
    Deformation<Number>
    deformation(const Increment<Number> &increment) const
    {
      return {law.predict(increment, time_step),
              increment.rotation,
              Number(1.) / increment.jacobian};
    }

    /// One of the two uniform ones for each particle. They turn alike.
    auto
    choose(const State &state) const
    {
      const auto         dense = is_dense(state, averaged.smallest_density);
      Deformation<Lanes> chosen;
      for (int i = 0; i < chosen.prediction.size(); ++i)
        chosen.prediction[i] = select(dense,
                                      Lanes(uniform.averaged.prediction[i]),
                                      Lanes(uniform.own.prediction[i]));
      chosen.inverse_jacobian = select(dense,
                                       Lanes(uniform.averaged.inverse_jacobian),
                                       Lanes(uniform.own.inverse_jacobian));
      return ParticleDeformation<decltype(chosen.prediction),
                                 decltype(uniform.own.rotation),
                                 Lanes>{chosen.prediction,
                                        uniform.own.rotation,
                                        chosen.inverse_jacobian};
    }

    struct Nothing
    {};

    /// What all particles of a cell have alike.
    struct Uniform
    {
      Deformation<double> own;
      /// Of dense particles.
      std::conditional_t<is_averaged, Deformation<double>, Nothing> averaged;
    };

    const Shape            &shape;
    const OfNodes          &velocities;
    const RateChange        change;
    const AveragedRate      averaged;
    const Law              &law;
    const StressIntegration integration;
    const double            time_step;

    std::conditional_t<Setting::has_uniform_strain, Uniform, Nothing> uniform;
  };
} // namespace Sandglass

#endif
