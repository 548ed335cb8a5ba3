#ifndef sandglass_run_run_h
#define sandglass_run_run_h

#include <sandglass/output/log.h>
#include <sandglass/run/command_line.h>
#include <sandglass/run/parameters.h>

#include <mpi.h>

namespace Sandglass
{
  /**
   * One simulation along the way of the data: parameters, scene, static stage,
   * particles, particle stage, observers. Collective. Throws InputError before
   * anything is written, RunError when it fails later.
   */
  void
  run(const Parameters  &parameters,
      const CommandLine &command_line,
      const MPI_Comm     communicator);
} // namespace Sandglass

#endif
