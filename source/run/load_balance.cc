#include <deal.II/base/mpi.h>

#include <sandglass/run/load_balance.h>

namespace Sandglass
{
  LoadBalance::LoadBalance(const Scene &scene)
    : n_ranks(Utilities::MPI::n_mpi_processes(scene.communicator))
    // Triangulation, degrees of freedom and a new stage: about 8 us per cell,
    // where a particle-step takes 30 ns.
    , cost(300. * scene.triangulation.n_active_cells())
  {}



  bool
  LoadBalance::is_lost(const ParticleStage &stage)
  {
    constexpr unsigned long interval = 100;
    if (n_ranks == 1 || stage.clock.step % interval != 0)
      return false;
    const auto n_particles =
      Utilities::MPI::min_max_avg(stage.cloud.n_locally_owned_particles(),
                                  stage.scene.communicator);
    waiting += interval * (n_particles.max - n_particles.avg);
    return waiting > cost;
  }



  std::vector<unsigned int>
  LoadBalance::cell_weights(const ParticleStage &stage)
  {
    constexpr unsigned int per_particle = 20, per_cell = 1;

    const ParticleBlocks     &blocks = stage.cloud.blocks();
    std::vector<unsigned int> weights(blocks.n_cells(), 0);
    blocks.for_each(
      [&](const ParticleSlot &slot) { weights[slot.cell] += per_particle; });
    Utilities::MPI::sum(weights, stage.scene.communicator, weights);
    for (unsigned int &weight : weights)
      weight += per_cell;
    return weights;
  }
} // namespace Sandglass
