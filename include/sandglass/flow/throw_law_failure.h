#ifndef sandglass_flow_throw_law_failure_h
#define sandglass_flow_throw_law_failure_h

#include <deal.II/base/mpi.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/material/law_failure.h>

#include <string>

namespace Sandglass
{
  /// End the run because a law has failed. With one rank results so far are
  /// kept; with several, the others don't know of it, and the run is cut short.
  [[noreturn]] inline void
  throw_law_failure(const std::string &message, const MPI_Comm communicator)
  {
    const std::string text =
      message + ". Try a smaller Particle stage/Time step safety or, at rest, "
                "more Static stage/Load steps; check the law's constants.";
    if (dealii::Utilities::MPI::n_mpi_processes(communicator) == 1)
      throw RunError(text);
    throw LawFailure(text);
  }
} // namespace Sandglass

#endif
