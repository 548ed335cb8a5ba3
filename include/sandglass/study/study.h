#ifndef sandglass_study_study_h
#define sandglass_study_study_h

#include <sandglass/run/command_line.h>
#include <sandglass/run/parameter_file.h>
#include <sandglass/run/parameters.h>

#include <mpi.h>

#include <string>

namespace Sandglass
{
  /// Several runs of one scene that answer a question together.
  struct Study
  {
    const char *name; ///< on the command line

    /**
     * Collective. Throws InputError before anything is written, RunError when
     * a run fails; the results of those before it are kept.
     *
     * @param parameters  of the scene; the runs' own are set in them.
     */
    void (*perform)(Parameters          &parameters,
                    const CommandLine   &command_line,
                    const ParameterFile &file,
                    const MPI_Comm       communicator);
  };

  /// The study of this name; throws InputError where there is none.
  const Study &
  find_study(const std::string &name);
} // namespace Sandglass

#endif
