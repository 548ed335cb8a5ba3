#ifndef sandglass_run_flow_state_h
#define sandglass_run_flow_state_h

#include <sandglass/flow/flow.h>

#include <mpi.h>

#include <string>

namespace Sandglass
{
  /// What a flow saves, as bytes; complete on rank 0. Collective.
  std::string
  saved_state(const Flow &flow);

  /// Put a flow into a saved state, which each rank has to know. Collective.
  void
  load_state(const std::string &state, Flow &flow);

  /// Carry a flow's state over to one on another partition of the same mesh, as
  /// a checkpoint would. Collective.
  void
  hand_over(const Flow &from, Flow &to, const MPI_Comm communicator);
} // namespace Sandglass

#endif
