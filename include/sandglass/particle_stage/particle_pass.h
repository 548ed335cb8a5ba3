#ifndef sandglass_particle_stage_particle_pass_h
#define sandglass_particle_stage_particle_pass_h

#include <sandglass/particle_stage/deformation.h>
#include <sandglass/particle_stage/nodal_sums.h>
#include <sandglass/particle_stage/particle_motion.h>
#include <sandglass/particle_stage/relocation.h>
#include <sandglass/particle_stage/stress_update.h>
#include <sandglass/particle_stage/volumetric_average.h>

namespace Sandglass
{
  /**
   * The one pass over the particles in a step of Section 4.4, block by block:
   * velocity (step 6), stress and density (step 8) and position (step 9) of
   * each particle, and its share of the next step's sums (steps 2 to 4).
   *
   * @tparam is_averaged  whether stressed particles take their cell's averaged
   *                      change of volume.
   */
  template <typename Setting, DensityUpdate density_update, bool is_averaged>
  class ParticlePass
  {
  public:
    static constexpr unsigned int n_nodes = Setting::nodes_per_cell;
    using Shape                           = CellShape<Setting::cell_type>;
    using Geometry                        = CellGeometry<Setting::cell_type>;

    ParticlePass(const Geometry                     &geometry,
                 const StressUpdate<density_update> &stress_update,
                 const VolumetricAverage<Setting>   &volumetric_average,
                 const StressIntegration             integration,
                 const double                        time_step)
      : geometry(geometry)
      , stress_update(stress_update)
      , volumetric_average(volumetric_average)
      , integration(integration)
      , time_step(time_step)
    {}

    /**
     * @param acceleration  of step 5, in m/s^2.
     * @param velocity      v^L of step 7, in m/s.
     * @param[out] sums     of the particles that are still in their cells.
     * @param[out] strays   the others, in the order that
     *                      ParticleBlocks::remove() asks for; their reference
     *                      coordinates are not valid.
     * @return the plastic work of the step in J.
     */
    double
    run(ParticleBlocks            &blocks,
        const NodalField<dim>     &acceleration,
        const NodalField<dim>     &velocity,
        NodalSums<Setting>        &sums,
        std::vector<ParticleSlot> &strays) const
    {
      strays.clear();
      Lanes dissipation(0.);
      run_with_widest_vectors([&]() {
        for_each_filled_cell(blocks, [&](const unsigned int cell) {
          const auto &nodes = geometry.nodes(cell);
          run_in_cell(blocks,
                      cell,
                      gather(acceleration, nodes),
                      gather(velocity, nodes),
                      dissipation,
                      sums,
                      strays);
        });
      });
      return sum(dissipation);
    }

  private:
    using OfNodes    = CellValues<dim, n_nodes>;
    using RateChange = typename CellIntegration<Setting>::RateChange;

    void
    run_in_cell(ParticleBlocks            &blocks,
                const unsigned int         cell,
                const OfNodes             &accelerations,
                const OfNodes             &velocities,
                Lanes                     &dissipation,
                NodalSums<Setting>        &sums,
                std::vector<ParticleSlot> &strays) const
    {
      const Shape &shape = geometry.shape(cell);
      Deformations common;
      RateChange   change;
      if constexpr (Setting::has_uniform_strain)
        common = deformations<double>(cell, shape, velocities, {}, {}, 1., {});
      else
        change = sums.rate_change(cell, velocities);

      CellSums<Setting, Lanes> cell_sums;
      cell_sums.clear();
      blocks.for_each_block_in_cell(cell, [&](const unsigned int block) {
        ParticleState<Lanes> state  = load_state(blocks[block]);
        const auto           values = Shape::shape_values(state.reference);
        accelerate(interpolate(accelerations, values), time_step, state);

        const Pair<Lanes> velocity = interpolate(velocities, values);
        if constexpr (!Setting::has_uniform_strain)
          common = deformations<Lanes>(cell,
                                       shape,
                                       velocities,
                                       state.reference,
                                       velocity,
                                       state.location[0],
                                       change);
        const Lanes work_density = update_stress(common, state);
        dissipation += state.volume() * work_density;

        move(velocity, time_step, shape, state);
        store_state(state, blocks[block]);

        const auto is_inside =
          Geometry::is_inside(state.reference, smallest_distance);
        if (!all(is_inside))
          add_strays(is_inside, {cell, block, 0}, blocks, strays);
        state.mass = select(is_inside, state.mass, Lanes(0.));
        cell_sums.add(state, sums.smallest_stiff_density, shape);
      });
      sum_lanes(cell_sums.values, sums[cell].values);
    }

    /// With the particle's own change of volume and with the cell's average.
    template <typename Number>
    struct OwnAndAveraged
    {
      ParticleDeformation<Number> own;
      ParticleDeformation<Number> averaged;
    };

    using Deformations = OwnAndAveraged<
      std::conditional_t<Setting::has_uniform_strain, double, Lanes>>;

    template <typename Number>
    OwnAndAveraged<Number>
    deformations(const unsigned int  cell,
                 const Shape        &shape,
                 const OfNodes      &velocities,
                 const Pair<Number> &reference,
                 const Pair<Number> &velocity,
                 const Number       &radius,
                 const RateChange   &change) const
    {
      auto gradient = gradient_of(velocities, shape.shape_gradients(reference));
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int e = 0; e < dim; ++e)
          {
            if constexpr (!Setting::has_uniform_strain)
              gradient[d][e] += change.gradient[d][e];
            gradient[d][e] *= time_step;
          }
      Number hoop(0.);
      if constexpr (Setting::has_hoop_strain)
        hoop = time_step * (velocity[0] / radius + change.hoop);
      const DeformationIncrement<Number> increment(gradient, hoop, integration);

      OwnAndAveraged<Number> result;
      result.own = deformation(increment);
      if constexpr (is_averaged)
        result.averaged = deformation(increment.with_volume_change(
          time_step * volumetric_average.rate(cell)));
      return result;
    }

    template <typename Number>
    ParticleDeformation<Number>
    deformation(const DeformationIncrement<Number> &increment) const
    {
      return {stress_update.law.elasticity.stress(increment.strain),
              increment.rotation,
              Number(1.) / increment.jacobian};
    }

    /// Step 8; returns the plastic work per volume in J/m^3.
    Lanes
    update_stress(const Deformations &common, ParticleState<Lanes> &state) const
    {
      if constexpr (!is_averaged)
        return stress_update(state, common.own);
      else
        {
          const auto is_stressed =
            state.density >= Lanes(volumetric_average.smallest_density);
          const auto choose = [&](const Lanes &averaged, const Lanes &own) {
            return select(is_stressed, averaged, own);
          };
          ParticleDeformation<Lanes> chosen;
          for (unsigned int c = 0; c < 4; ++c)
            chosen.elastic_stress[c] = choose(common.averaged.elastic_stress[c],
                                              common.own.elastic_stress[c]);
          chosen.rotation         = {common.own.rotation.cosine,
                                     common.own.rotation.sine};
          chosen.inverse_jacobian = choose(common.averaged.inverse_jacobian,
                                           common.own.inverse_jacobian);
          return stress_update(state, chosen);
        }
    }

    static void
    add_strays(const Lanes::Mask         &is_inside,
               ParticleSlot               slot,
               const ParticleBlocks      &blocks,
               std::vector<ParticleSlot> &strays)
    {
      for (slot.lane = blocks.n_lanes(slot.block); slot.lane-- > 0;)
        if (!is_inside[slot.lane])
          strays.push_back(slot);
    }

    const Geometry                     &geometry;
    const StressUpdate<density_update> &stress_update;
    const VolumetricAverage<Setting>   &volumetric_average;
    const StressIntegration             integration;
    const double                        time_step;

    static constexpr double smallest_distance =
      Relocation<Setting::cell_type>::margin;
  };
} // namespace Sandglass

#endif
