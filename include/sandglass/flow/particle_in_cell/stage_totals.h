#ifndef sandglass_flow_particle_in_cell_stage_totals_h
#define sandglass_flow_particle_in_cell_stage_totals_h

#include <deal.II/base/mpi.h>

#include <sandglass/base/instruction_sets.h>
#include <sandglass/flow/flow_view.h>
#include <sandglass/flow/particle_in_cell/law_interface.h>
#include <sandglass/flow/particle_in_cell/removed_mass.h>
#include <sandglass/particles/particle_state.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Sandglass
{
  /// Sums over the particles of each lane, for FlowTotals.
  template <typename Setting>
  struct LaneTotals
  {
    static constexpr int dim = Setting::dim;

    enum Sum : unsigned int
    {
      mass_in_silo,
      mass_falling,
      kinetic_energy,
      elastic_energy,
      momentum,
      n_sums = momentum + dim
    };

    std::array<Lanes, n_sums> sums;
    Lanes                     largest_squared_speed;

    LaneTotals()
      : largest_squared_speed(0.)
    {
      sums.fill(Lanes(0.));
    }

    /// Lanes without a particle have no mass and the first one's speed.
    void
    add(const ParticleState<typename Setting::Layout, Lanes> &state,
        const LawInterface<Setting>                          &law)
    {
      const Lanes &mass   = state.mass;
      Lanes        square = state.velocity[0] * state.velocity[0];
      for (unsigned int d = 1; d < dim; ++d)
        square += state.velocity[d] * state.velocity[d];
      const auto falls = state.location[1] < Lanes(0.);

      sums[mass_in_silo] += select(falls, Lanes(0.), mass);
      sums[mass_falling] += select(falls, mass, Lanes(0.));
      sums[kinetic_energy] += Lanes(0.5) * mass * square;
      Lanes energy_density;
      law.energy_density(state, energy_density);
      sums[elastic_energy] += energy_density * state.volume();
      for (unsigned int d = 0; d < dim; ++d)
        sums[momentum + d] += mass * state.velocity[d];
      largest_squared_speed =
        select(largest_squared_speed < square, square, largest_squared_speed);
    }
  };



  /**
   * The totals of all ranks. Collective.
   *
   * @param removed,dissipated_energy,wall_work,particle_steps  of this rank.
   */
  template <typename Setting>
  FlowTotals
  sum_up(const ParticleBlocks<typename Setting::Layout> &blocks,
         const LawInterface<Setting>                    &law,
         const RemovedMass                              &removed,
         const double                                    dissipated_energy,
         const double                                    wall_work,
         const unsigned long                             particle_steps,
         const MPI_Comm                                  communicator)
  {
    using Totals = LaneTotals<Setting>;
    // In order of cells, which doesn't depend on history.
    Totals of_lanes;
    run_with_widest_vectors([&]() {
      for_each_filled_cell(blocks, [&](const unsigned int cell) {
        blocks.for_each_block_in_cell(cell, [&](const unsigned int block) {
          of_lanes.add(load_state(blocks[block]), law);
        });
      });
    });

    constexpr unsigned int    n = Totals::n_sums;
    std::array<double, n + 4> sums;
    for (unsigned int i = 0; i < n; ++i)
      sums[i] = sum(of_lanes.sums[i]);
    sums[n]     = removed.discharged;
    sums[n + 1] = removed.lost;
    sums[n + 2] = dissipated_energy;
    sums[n + 3] = wall_work;
    const ArrayView<double> view(sums.data(), sums.size());
    Utilities::MPI::sum(ArrayView<const double>(view), communicator, view);

    FlowTotals totals;
    totals.dissipation_can_fall = law.dissipation_can_fall;
    totals.mass_in_silo         = sums[Totals::mass_in_silo];
    totals.mass_falling         = sums[Totals::mass_falling];
    totals.mass_removed         = sums[n];
    totals.mass_lost            = sums[n + 1];
    totals.kinetic_energy       = sums[Totals::kinetic_energy];
    totals.elastic_energy       = sums[Totals::elastic_energy];
    totals.dissipated_energy    = sums[n + 2];
    totals.wall_work            = sums[n + 3];
    for (unsigned int d = 0; d < Setting::dim; ++d)
      totals.momentum[d] = sums[Totals::momentum + d];

    totals.n_particles =
      Utilities::MPI::sum(static_cast<unsigned long>(blocks.n_particles()),
                          communicator);
    totals.particle_steps = Utilities::MPI::sum(particle_steps, communicator);
    double largest_square = 0.;
    for (unsigned int lane = 0; lane < Lanes::n; ++lane)
      largest_square =
        std::max(largest_square, of_lanes.largest_squared_speed[lane]);
    totals.largest_speed =
      Utilities::MPI::max(std::sqrt(largest_square), communicator);
    return totals;
  }
} // namespace Sandglass

#endif
