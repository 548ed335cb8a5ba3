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

    /// What the flow and the observers need to go on, in their own words.
    std::string flow, observers;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &time &cell_weights &balance &flow &observers;
    }
  };

  /// The checkpoint's file in an output directory.
  std::string
  checkpoint_file(const std::string &directory);

  /// Write the file in one go. On one rank. Throws RunError.
  void
  write_checkpoint(const std::string &directory,
                   const Fingerprint &fingerprint,
                   const Checkpoint  &checkpoint);

  /**
   * Read the file. On each rank. Throws InputError if there is none, or if its
   * run can't go on with these parameters, see refuse_changes().
   *
   * @param end_time  of the run, which has to be later than the checkpoint's,
   * in s.
   */
  Checkpoint
  read_checkpoint(const std::string &directory,
                  const Fingerprint &fingerprint,
                  const double       end_time);
} // namespace Sandglass

#endif
