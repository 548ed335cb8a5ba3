#ifndef sandglass_run_part_h
#define sandglass_run_part_h

#include <sandglass/flow/dynamic_flow.h>
#include <sandglass/output/observers.h>
#include <sandglass/run/checkpoint.h>
#include <sandglass/run/load_balance.h>
#include <sandglass/run/parameters.h>

#include <memory>
#include <vector>

namespace Sandglass
{
  /// What works on one partition of the mesh: a flow, and who observes it.
  template <int dim>
  struct Part
  {
    /// @param mesh          with its gates.
    /// @param closed_faces  where they are closed, see Gates.
    /// @param cell_weights  for the partition; none: by the filled cells.
    Part(const Parameters                &parameters,
         const Mesh<dim>                 &mesh,
         const std::vector<bool>         &closed_faces,
         const std::vector<unsigned int> &cell_weights,
         const MPI_Comm                   communicator,
         Log                             &log,
         TimerOutput                     &timings);

    /// All that go_on_from() needs; complete on rank 0. Collective.
    Checkpoint
    take_checkpoint();

    /// On a partition by the checkpoint's weights, for the same results.
    /// Collective.
    void
    go_on_from(const Checkpoint &checkpoint);

    /// Go on where another partition has stopped. Collective.
    void
    go_on_from(Part &before);

    const std::vector<bool>                 closed_faces;
    const Scene<dim>                        scene;
    const std::unique_ptr<DynamicFlow<dim>> flow;
    LoadBalance                             balance;
    Observers<dim>                          observers;
  };
} // namespace Sandglass

#endif
