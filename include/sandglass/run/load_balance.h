#ifndef sandglass_run_load_balance_h
#define sandglass_run_load_balance_h

#include <sandglass/flow/flow.h>

#include <mpi.h>

#include <vector>

namespace Sandglass
{
  /**
   * How long the ranks have waited for each other on one partition. As a silo
   * empties, the ranks at its top run out of particles, and wait at each step
   * for those that have more, or that have more of the flow. It is time for
   * another partition when they have waited for longer than that takes, for
   * more work than it could help at its start.
   *
   * Decided by what the cells cost, not by times, so that runs repeat exactly.
   */
  class LoadBalance
  {
  public:
    /// To be asked between steps, once. Collective; costs nothing in most
    /// steps.
    bool
    is_lost(const Flow &flow, const MPI_Comm communicator);

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &wait_at_start &wait;
    }

  private:
    /// Of the rank that has most work beyond the mean, in a step, as
    /// cell_work() measures it: when the partition was new (negative: not known
    /// yet), and what has come together beyond that.
    double wait_at_start = -1., wait = 0.;
  };

  /// What each cell costs in a step now, for the next partition: all cells' on
  /// each rank. Collective.
  std::vector<unsigned int>
  cell_weights(const Flow &flow, const MPI_Comm communicator);
} // namespace Sandglass

#endif
