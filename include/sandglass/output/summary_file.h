#ifndef sandglass_output_summary_file_h
#define sandglass_output_summary_file_h

#include <string>

namespace Sandglass
{
  /// What summary.json says of the state of a run. A run that has been killed
  /// is still `running` there, since nothing could say otherwise.
  namespace Status
  {
    inline const std::string running = "running", finished = "finished",
                             failed = "failed", stopped = "stopped";
  } // namespace Status

  /// The file in an output directory.
  std::string
  summary_file(const std::string &directory);

  /**
   * Replace the file in one go or, where the disk is too full for a second one,
   * write over it. On one rank. Throws RunError.
   */
  void
  write_summary_file(const std::string &directory, const std::string &text);

  /**
   * Change nothing in the file but the state and the message, as a rank does
   * that has failed alone: what else is in it is known to rank 0. Does nothing
   * where there is no file that is `running`.
   *
   * @param rank  that writes.
   */
  void
  amend_summary_file(const std::string &directory,
                     const std::string &status,
                     const std::string &message,
                     const unsigned int rank);
} // namespace Sandglass

#endif
