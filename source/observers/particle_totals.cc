#include <deal.II/base/mpi.h>

#include <sandglass/observers/particle_totals.h>
#include <sandglass/particles/particle_state.h>

#include <array>

namespace Sandglass
{
  namespace
  {
    enum Sum : unsigned int
    {
      mass_in_silo,
      mass_falling,
      mass_removed,
      mass_lost,
      kinetic_energy,
      elastic_energy,
      dissipated_energy,
      momentum_x,
      momentum_y,
      n_sums
    };

    using Sums = std::array<double, n_sums>;



    Sums
    sums_of_cell(const ParticleBlocks &blocks,
                 const unsigned int    cell,
                 const Elasticity     &elasticity)
    {
      Sums sums{};
      blocks.for_each_in_cell(cell, [&](const ParticleSlot &slot) {
        const auto   state = load_state(blocks[slot.block], slot.lane);
        const double mass  = state.mass;
        const double u     = state.velocity[0];
        const double v     = state.velocity[1];

        sums[state.location[1] < 0. ? mass_falling : mass_in_silo] += mass;
        sums[kinetic_energy] += 0.5 * mass * (u * u + v * v);
        sums[elastic_energy] +=
          elasticity.energy_density(state.stress) * state.volume();
        sums[momentum_x] += mass * u;
        sums[momentum_y] += mass * v;
      });
      return sums;
    }



    /// This rank's sums. In order of cells, which doesn't depend on history,
    /// and cell by cell, which keeps rounding small.
    Sums
    sums_of_rank(ParticleStage &stage, const Elasticity &elasticity)
    {
      Sums sums{};
      for (const auto &cell : stage.cloud.owned_cells())
        {
          const Sums of_cell = sums_of_cell(stage.cloud.blocks(),
                                            cell->active_cell_index(),
                                            elasticity);
          for (unsigned int i = 0; i < n_sums; ++i)
            sums[i] += of_cell[i];
        }
      sums[mass_removed] = stage.removed_mass().discharged;
      sums[mass_lost]    = stage.removed_mass().lost;
      sums[dissipated_energy] =
        stage.plastic_dissipation + stage.contact.friction_dissipation();
      return sums;
    }
  } // namespace



  ParticleTotals::ParticleTotals(ParticleStage    &stage,
                                 const Elasticity &elasticity)
  {
    const MPI_Comm communicator = stage.scene.communicator;

    Sums                    sums = sums_of_rank(stage, elasticity);
    const ArrayView<double> view(sums.data(), sums.size());
    Utilities::MPI::sum(ArrayView<const double>(view), communicator, view);

    const double factor = stage.scene.symmetry_factor;
    mass_in_silo        = factor * sums[Sum::mass_in_silo];
    mass_falling        = factor * sums[Sum::mass_falling];
    mass_removed        = factor * sums[Sum::mass_removed];
    mass_lost           = factor * sums[Sum::mass_lost];
    kinetic_energy      = factor * sums[Sum::kinetic_energy];
    elastic_energy      = factor * sums[Sum::elastic_energy];
    dissipated_energy   = factor * sums[Sum::dissipated_energy];
    momentum[0]         = sums[Sum::momentum_x];
    momentum[1]         = factor * sums[Sum::momentum_y];

    n_particles =
      Utilities::MPI::sum(static_cast<unsigned long>(
                            stage.cloud.n_locally_owned_particles()),
                          communicator);
    particle_steps = Utilities::MPI::sum(stage.particle_steps, communicator);
    largest_speed  = Utilities::MPI::max(stage.largest_speed(), communicator);
  }
} // namespace Sandglass
