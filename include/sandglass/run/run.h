#ifndef sandglass_run_run_h
#define sandglass_run_run_h

#include <sandglass/output/log.h>
#include <sandglass/run/command_line.h>
#include <sandglass/run/parameters.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /**
   * One simulation along the way of the data: parameters, scene, static stage,
   * particles, particle stage, observers. Collective. Throws InputError before
   * anything is written, RunError when it fails later.
   *
   * Where the command line asks for a check only, it stops when the input has
   * been read.
   *
   * @param warnings  about the parameter file, for the log.
   */
  void
  run(const Parameters               &parameters,
      const CommandLine              &command_line,
      const std::vector<std::string> &warnings,
      const MPI_Comm                  communicator);
} // namespace Sandglass

#endif
