#ifndef sandglass_run_load_balance_h
#define sandglass_run_load_balance_h

#include <sandglass/particle_stage/particle_stage.h>

#include <vector>

namespace Sandglass
{
  /**
   * When ranks should share the cells out anew. As a silo empties, the ranks at
   * its top run out of particles, and wait at each step for those that have
   * more.
   *
   * Decided by counts, not by times, so that runs repeat exactly.
   */
  class LoadBalance
  {
  public:
    /// For a new partition.
    explicit LoadBalance(const Scene &scene);

    /**
     * After a step: whether the ranks have by now waited for longer than a new
     * partition takes. Collective; costs nothing in most steps.
     */
    bool
    is_lost(const ParticleStage &stage);

    /// What each cell costs in a step now, for the next partition: all cells'
    /// on each rank. Collective.
    static std::vector<unsigned int>
    cell_weights(const ParticleStage &stage);

  private:
    const unsigned int n_ranks;
    /// What a new partition costs, in particle-steps.
    const double cost;
    /// What the other ranks have waited for the fullest, in particle-steps.
    double waiting = 0.;
  };
} // namespace Sandglass

#endif
