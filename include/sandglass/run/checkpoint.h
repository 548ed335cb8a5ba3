#ifndef sandglass_run_checkpoint_h
#define sandglass_run_checkpoint_h

#include <sandglass/run/fingerprint.h>
#include <sandglass/run/load_balance.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <string>
#include <vector>

namespace Sandglass
{
  /**
   * All that a run needs to go on as if it had not stopped: bit by bit the same
   * on the same number of ranks with the same partitioner, up to rounding
   * otherwise.
   */
  struct Checkpoint
  {
    double time = 0.; ///< in s

    /// The partition and how even it is, so that sums keep their order.
    std::vector<unsigned int> cell_weights;
    LoadBalance               balance;

    /// Where gates are closed, see Gates.
    std::vector<bool> closed_faces;

    /// What the flow and the observers need to go on, in their own words.
    std::string flow, observers;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &time &cell_weights &balance &closed_faces &flow &observers;
    }
  };

  /// Write it, see CheckpointFiles. On one rank. Throws RunError.
  void
  write_checkpoint(const std::string &directory,
                   const Fingerprint &fingerprint,
                   const Checkpoint  &checkpoint);

  /// Where a checkpoint is.
  struct CheckpointPlace
  {
    /// @param path  of a run's output directory, for its last checkpoint, or of
    ///              the file of a checkpoint there.
    explicit CheckpointPlace(const std::string &path);

    std::string directory, file;
  };

  /**
   * Read it. On each rank. Throws InputError if it isn't there or damaged, and
   * offers the one before it then if that is whole; or if its run can't go on
   * with these parameters, see refuse_changes().
   *
   * @param end_time  of the run, which has to be later than the checkpoint's,
   * in s.
   */
  Checkpoint
  read_checkpoint(const CheckpointPlace &place,
                  const Fingerprint     &fingerprint,
                  const double           end_time);
} // namespace Sandglass

#endif
