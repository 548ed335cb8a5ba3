#ifndef sandglass_study_silo_study_h
#define sandglass_study_silo_study_h

#include <sandglass/run/run.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /// Refuse scenes that have no flow rate, or of which the program can't make
  /// variants; throws InputError.
  /// @param study  its name on the command line.
  void
  check_flowing_silo(const SceneParameters &scene, const std::string &study);

  /// One run of a study, in its own directory; only progress on the screen.
  RunResult
  run_variant(const Parameters               &parameters,
              const CommandLine              &command_line,
              const std::string              &directory,
              const std::vector<std::string> &warnings,
              const MPI_Comm                  communicator);

  /// A number with three digits, as in names of directories.
  std::string
  short_text(const double value);
} // namespace Sandglass

#endif
