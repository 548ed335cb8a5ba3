#ifndef sandglass_output_banner_h
#define sandglass_output_banner_h

#include <mpi.h>

#include <string>

namespace Sandglass
{
  /// Name and version of the program, with the commit it was built from.
  std::string
  name_and_version();

  /**
   * The lines that a run begins with: versions of the program and of the
   * libraries that its results depend on, number of ranks, kind of build.
   */
  std::string
  banner(const MPI_Comm communicator);
} // namespace Sandglass

#endif
