#include <deal.II/base/mpi.h>

#include <sandglass/run/load_balance.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  namespace
  {
    /// Call `function(cell index, work)` for this rank's cells, see
    /// cell_work().
    template <typename Function>
    void
    for_each_cell_work(const ParticleStage &stage, const Function &function)
    {
      // How many edges a line of unit length crosses on average in a mesh of
      // cells of unit area: a cell's perimeter over pi times its area.
      constexpr double crossings = 1.4;

      const ParticleBlocks &blocks = stage.cloud.blocks();
      for (const auto &cell : stage.cloud.owned_cells())
        {
          const unsigned int index       = cell->active_cell_index();
          unsigned int       n_particles = 0;
          double             speeds      = 0.;
          blocks.for_each_in_cell(index, [&](const ParticleSlot &slot) {
            ++n_particles;
            const ParticleBlock &block = blocks[slot.block];
            speeds += block.point(ParticleBlock::velocity, slot.lane).norm();
          });
          if (n_particles == 0)
            continue;
          const double n_leaving =
            std::min<double>(n_particles,
                             speeds * stage.clock.time_step * crossings /
                               std::sqrt(cell->measure()));
          function(index, cell_work(n_particles, n_leaving));
        }
    }
  } // namespace



  bool
  is_balance_lost(ParticleStage &stage)
  {
    constexpr unsigned long interval = 100;
    // Triangulation, degrees of freedom and a new stage: about 2 us per cell,
    // where a particle takes 20 ns.
    constexpr double cost_of_cell = 100.;

    const MPI_Comm communicator = stage.scene.communicator;
    if (Utilities::MPI::n_mpi_processes(communicator) == 1 ||
        stage.clock.step % interval != 0)
      return false;

    double own_work = 0.;
    for_each_cell_work(stage, [&](const unsigned int, const double work) {
      own_work += work;
    });
    const auto   work    = Utilities::MPI::min_max_avg(own_work, communicator);
    const double more    = work.max - work.avg;
    Waiting     &waiting = stage.waiting;
    if (waiting.at_start < 0.)
      waiting.at_start = more;
    waiting.total += interval * std::max(0., more - waiting.at_start);
    return waiting.total > cost_of_cell * stage.scene.mesh.cells.size();
  }



  std::vector<unsigned int>
  cell_weights(const ParticleStage &stage)
  {
    std::vector<double> of_cells(stage.cloud.blocks().n_cells(), 0.);
    for_each_cell_work(stage, [&](const unsigned int cell, const double work) {
      of_cells[cell] = work;
    });
    Utilities::MPI::sum(of_cells, stage.scene.communicator, of_cells);
    return cell_weights(of_cells);
  }
} // namespace Sandglass
