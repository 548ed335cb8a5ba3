#ifndef sandglass_run_run_h
#define sandglass_run_run_h

#include <sandglass/output/flow_rate.h>
#include <sandglass/output/log.h>
#include <sandglass/output/summary.h>
#include <sandglass/run/command_line.h>
#include <sandglass/run/parameters.h>
#include <sandglass/run/stop_signals.h>

#include <mpi.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace Sandglass
{
  /// What a run has come to; its flow rates are known on rank 0.
  struct RunResult
  {
    Summary  summary;
    FlowRate discharge;
  };

  /**
   * One simulation along the way of the data: parameters, scene, static stage,
   * particles, particle stage, observers. Collective. Throws InputError before
   * anything is written, RunError when it fails later, RunStopped when a signal
   * has stopped it.
   *
   * Where the command line asks for a check only, it stops when the input has
   * been read.
   *
   * @param warnings  about the parameter file, for the log.
   * @param before_writing  is called when the input is accepted, and nothing
   *                        has been written yet. Collective.
   * @return          nothing where it only checks.
   */
  std::optional<RunResult>
  run(const Parameters               &parameters,
      const CommandLine              &command_line,
      const std::vector<std::string> &warnings,
      const MPI_Comm                  communicator,
      Log                            &log,
      const std::function<void()>    &before_writing = {});
} // namespace Sandglass

#endif
