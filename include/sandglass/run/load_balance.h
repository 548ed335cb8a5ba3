#ifndef sandglass_run_load_balance_h
#define sandglass_run_load_balance_h

#include <sandglass/flow/particle_in_cell/particle_stage.h>

#include <vector>

namespace Sandglass
{
  /**
   * Between steps, once: whether ranks should share the cells out anew. As a
   * silo empties, the ranks at its top run out of particles, and wait at each
   * step for those that have more, or that have more of the flow; it is time
   * when they have waited for longer than a new partition takes, for more work
   * than the partition could help at its start. Collective; costs nothing in
   * most steps.
   *
   * Decided by what particles there are and how fast they are, not by times, so
   * that runs repeat exactly.
   */
  bool
  is_balance_lost(ParticleStage &stage);

  /// What each cell costs in a step now, for the next partition: all cells' on
  /// each rank. Collective.
  std::vector<unsigned int>
  cell_weights(const ParticleStage &stage);
} // namespace Sandglass

#endif
