#ifndef sandglass_study_convergence_study_h
#define sandglass_study_convergence_study_h

#include <sandglass/run/command_line.h>
#include <sandglass/run/parameter_file.h>
#include <sandglass/run/parameters.h>

#include <mpi.h>

namespace Sandglass
{
  /**
   * A silo on a sequence of meshes, each in a directory of its own below the
   * output directory: how its flow rate depends on the cells' size, and what it
   * is on cells of size zero, see extrapolate().
   *
   * The rate is the mean from 3 sqrt(D / g) after the outlet opens to the end
   * of the run, with the outlet's width D: flow has formed by then. Where a
   * silo empties before, it is that of the middle half of its mass. Runs end
   * at 5 sqrt(D / g), unless the parameter file ends them before or the command
   * line sets an end.
   *
   * Arguments and errors are those of Study::perform().
   */
  void
  study_convergence(Parameters          &parameters,
                    const CommandLine   &command_line,
                    const ParameterFile &file,
                    const MPI_Comm       communicator);
} // namespace Sandglass

#endif
