#ifndef sandglass_flow_particle_in_cell_particle_pass_h
#define sandglass_flow_particle_in_cell_particle_pass_h

#include <sandglass/flow/particle_in_cell/cell_deformation.h>
#include <sandglass/flow/particle_in_cell/nodal_sums.h>
#include <sandglass/flow/particle_in_cell/particle_motion.h>
#include <sandglass/flow/particle_in_cell/relocation.h>
#include <sandglass/flow/particle_in_cell/volumetric_average.h>
#include <sandglass/material/law_failure.h>
#include <sandglass/particles/strays.h>

#include <sstream>

namespace Sandglass
{
  /**
   * The one pass over the particles in a step of Section 4.4, block by block:
   * velocity (step 6), stress and density (step 8) and position (step 9) of
   * each particle, and its share of the next step's sums (steps 2 to 4).
   *
   * @tparam is_averaged  whether particles take averaged changes of volume.
   */
  template <typename Setting, typename Law, bool is_averaged>
  class ParticlePass
  {
  public:
    static constexpr unsigned int n_nodes = Setting::nodes_per_cell;
    static constexpr int          dim     = Setting::dim;

    using Layout   = typename Setting::Layout;
    using Shape    = typename Setting::Shape;
    using Geometry = CellGeometry<Setting::cell_type>;
    using Blocks   = ParticleBlocks<Layout>;

    ParticlePass(const Geometry          &geometry,
                 const StressUpdate<Law> &stress_update,
                 const StressIntegration  integration,
                 const double             pic_share,
                 const double             time_step)
      : geometry(geometry)
      , stress_update(stress_update)
      , integration(integration)
      , pic_share(pic_share)
      , time_step(time_step)
    {}

    /**
     * @param acceleration  of step 5, in m/s^2.
     * @param velocity      v^L of step 7, in m/s.
     * @param[out] sums     over the particles that are still in their cells.
     * @param[in,out] volumetric_average  that of `velocity`; then the sums for
     *                      the next one.
     * @param[out] strays   the other particles, taken out of the blocks.
     * @return the plastic work of the step in J.
     */
    double
    run(Blocks                     &blocks,
        const NodalField<dim>      &acceleration,
        const NodalField<dim>      &velocity,
        NodalSums<Setting>         &sums,
        VolumetricAverage<Setting> &volumetric_average,
        Strays<Layout>             &strays) const
    {
      strays.clear();
      Lanes      dissipation(0.);
      const auto pass = [&]() {
        for_each_cell_of_particles(blocks, [&](const unsigned int cell) {
          const auto &nodes = geometry.nodes(cell);
          run_in_cell(blocks,
                      cell,
                      gather(acceleration, nodes),
                      gather(velocity, nodes),
                      dissipation,
                      sums,
                      volumetric_average,
                      strays);
        });
      };
      if constexpr (has_use_of_widest_vectors)
        run_with_widest_vectors(pass);
      else
        InstructionSets::run_as_built(pass);
      return sum(dissipation);
    }

  private:
    using OfNodes     = CellValues<dim, n_nodes>;
    using Deformation = CellDeformation<Setting, Law, is_averaged>;

    /// Laws that can fail, or whose stiffness changes with the state, take one
    /// particle after the other, and most of the time. In space their passes
    /// are compiled once only.
    static constexpr bool has_use_of_widest_vectors =
      dim == 2 || (Law::has_constant_stiffness && !Law::can_fail);

    static constexpr bool has_volumetric_sums =
      is_averaged && !Setting::has_uniform_strain;

    void
    run_in_cell(Blocks                     &blocks,
                const unsigned int          cell,
                const OfNodes              &accelerations,
                const OfNodes              &velocities,
                Lanes                      &dissipation,
                NodalSums<Setting>         &sums,
                VolumetricAverage<Setting> &volumetric_average,
                Strays<Layout>             &strays) const
    {
      const Shape &shape = geometry.shape(cell);

      typename Deformation::RateChange change;
      AveragedRate                     averaged{};
      if constexpr (is_averaged)
        {
          change   = volumetric_average.rate_change(cell);
          averaged = {volumetric_average.rate(cell),
                      volumetric_average.separated_compaction(cell),
                      volumetric_average.smallest_density};
        }
      else if constexpr (!Setting::has_uniform_strain)
        change = sums.rate_change(cell, velocities);
      const Deformation deformation(shape,
                                    velocities,
                                    change,
                                    averaged,
                                    stress_update.law,
                                    integration,
                                    time_step);

      CellSums<Setting, Lanes>       cell_sums;
      VolumetricSums<Setting, Lanes> volumetric_sums;
      cell_sums.clear();
      volumetric_sums.clear();
      blocks.for_each_block_in_cell(cell, [&](const unsigned int block) {
        ParticleState<Layout, Lanes> state = load_state(blocks[block]);
        const auto values = Shape::shape_values(state.reference);
        accelerate(interpolate(accelerations, values), time_step, state);

        const auto velocity = interpolate(velocities, values);
        if constexpr (dim == 3) // in the plane the share is zero
          approach(velocity, pic_share, state);
        const Lanes work_density = update_stress(state,
                                                 deformation(state, velocity),
                                                 {cell, block, 0},
                                                 blocks);
        dissipation += state.volume() * work_density;

        move(velocity, time_step, shape, state);
        store_state(state, blocks[block]);

        const auto is_inside =
          Geometry::is_inside(state.reference, smallest_distance);
        if (!all(is_inside))
          add_strays(is_inside, {cell, block, 0}, blocks, strays);
        state.mass = select(is_inside, state.mass, Lanes(0.));
        cell_sums.add(state, sums.cells.smallest_density, shape);
        if constexpr (has_volumetric_sums)
          volumetric_sums.add(state,
                              volumetric_average.smallest_density,
                              shape);
      });
      strays.take_out(blocks);
      sums.cells.set(cell, cell_sums);
      if constexpr (has_volumetric_sums)
        volumetric_average.cells->set(cell, volumetric_sums);
    }

    /// Step 8. Where the law fails, the message names the particle.
    template <typename State, typename ParticleDeformation>
    Lanes
    update_stress(State                     &state,
                  const ParticleDeformation &deformation,
                  ParticleSlot               slot,
                  const Blocks              &blocks) const
    {
      if constexpr (!Law::can_fail)
        return stress_update(state, deformation);
      else
        try
          {
            return stress_update(state, deformation);
          }
        catch (const LawFailure &failure)
          {
            slot.lane = failure.lane;
            std::ostringstream message;
            message << "particle " << blocks.id(slot) << " at ("
                    << state.location[0][slot.lane];
            for (int d = 1; d < dim; ++d)
              message << ", " << state.location[d][slot.lane];
            message << ") m: " << failure.what();
            throw LawFailure(message.str());
          }
    }

    static void
    add_strays(const Lanes::Mask &is_inside,
               ParticleSlot       slot,
               const Blocks      &blocks,
               Strays<Layout>    &strays)
    {
      for (slot.lane = blocks.n_lanes(slot.block); slot.lane-- > 0;)
        if (!is_inside[slot.lane])
          strays.add(slot);
    }

    const Geometry          &geometry;
    const StressUpdate<Law> &stress_update;
    const StressIntegration  integration;
    const double             pic_share;
    const double             time_step;

    static constexpr double smallest_distance = Relocation<Setting>::margin;
  };
} // namespace Sandglass

#endif
