#ifndef sandglass_output_output_directory_h
#define sandglass_output_output_directory_h

#include <sandglass/output/log.h>
#include <sandglass/output/output_parameters.h>

#include <functional>

namespace Sandglass
{
  /**
   * Make the output directory, open sandglass.log in it, and write
   * parameters.prm, which holds all parameters as used. Collective. Throws
   * InputError on each rank if the directory can't be written.
   *
   * @param is_restart  whether the log goes on behind that of an earlier run.
   * @param folder      to make in it for the fields' files; empty: none.
   */
  void
  prepare_output_directory(const OutputParameters &parameters,
                           const bool              is_restart,
                           const MPI_Comm          communicator,
                           Log                    &log,
                           const std::string      &folder = "vtu");

  /**
   * Do work in which ranks don't wait for each other, and tell all of them if
   * it went wrong on one. Collective.
   *
   * @return the message of the exception on the first rank that had one, or an
   *         empty text.
   */
  std::string
  shared_error(const MPI_Comm communicator, const std::function<void()> &work);

  /// Like shared_error(), but throws a RunError on each rank.
  void
  do_and_share_errors(const MPI_Comm               communicator,
                      const std::function<void()> &work);
} // namespace Sandglass

#endif
