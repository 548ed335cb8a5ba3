#include <deal.II/base/mpi.h>

#include <sandglass/run/load_balance.h>

#include <algorithm>

namespace Sandglass
{
  bool
  is_balance_lost(ParticleStage &stage)
  {
    constexpr unsigned long interval = 100;
    // Triangulation, degrees of freedom and a new stage: about 8 us per cell,
    // where a particle-step takes 30 ns.
    constexpr double cost_of_cell = 300.;

    const MPI_Comm communicator = stage.scene.communicator;
    if (Utilities::MPI::n_mpi_processes(communicator) == 1 ||
        stage.clock.step % interval != 0)
      return false;

    const auto n_particles =
      Utilities::MPI::min_max_avg(stage.cloud.n_locally_owned_particles(),
                                  communicator);
    const double more    = n_particles.max - n_particles.avg;
    Waiting     &waiting = stage.waiting;
    if (waiting.at_start < 0.)
      waiting.at_start = more;
    waiting.total += interval * std::max(0., more - waiting.at_start);
    return waiting.total > cost_of_cell * stage.scene.mesh.cells.size();
  }



  std::vector<unsigned int>
  cell_weights(const ParticleStage &stage)
  {
    const ParticleBlocks     &blocks = stage.cloud.blocks();
    std::vector<unsigned int> n_particles(blocks.n_cells(), 0);
    blocks.for_each(
      [&](const ParticleSlot &slot) { ++n_particles[slot.cell]; });
    Utilities::MPI::sum(n_particles, stage.scene.communicator, n_particles);
    return cell_weights(n_particles);
  }
} // namespace Sandglass
