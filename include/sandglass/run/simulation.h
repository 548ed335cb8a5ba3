#ifndef sandglass_run_simulation_h
#define sandglass_run_simulation_h

#include <sandglass/output/output_directory.h>
#include <sandglass/run/checkpoint_writer.h>
#include <sandglass/run/part.h>
#include <sandglass/run/run.h>
#include <sandglass/run/stop_events.h>
#include <sandglass/scene/gates.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace Sandglass
{
  /// One simulation in a space dimension.
  template <int dim>
  class Simulation
  {
  public:
    /// Read the input; nothing is written yet. The arguments have to live as
    /// long as this does.
    Simulation(const Parameters  &parameters,
               const CommandLine &command_line,
               const MPI_Comm     communicator,
               Log               &log);

    /// Into a directory that this run has for itself.
    RunResult
    run(OutputDirectory             &directory,
        const std::function<void()> &before_writing);

  private:
    Mesh<dim>
    timed_mesh();

    /// @param closed_faces  see Gates.
    std::unique_ptr<Part<dim>>
    make_part(const std::vector<unsigned int> &cell_weights,
              const std::vector<bool>         &closed_faces);

    /// The place of the checkpoint to go on from, if the command line asks
    /// for that.
    std::optional<CheckpointPlace>
    checkpoint_place() const;

    /// That checkpoint; the part is then on its partition.
    Checkpoint
    find_checkpoint(const CheckpointPlace &place);

    RunResult
    run_to_end(const std::optional<Checkpoint> &checkpoint,
               StopSignals                     &signals);

    void
    start(StopSignals &signals);

    void
    go_on_from(const Checkpoint &checkpoint);

    /// Run to the end. Ranks share the cells out anew where they should, and
    /// gates move.
    void
    flow_to_end(StopSignals &signals);

    /// Run to the end, or until the part has to be another one.
    void
    flow_on_part(StopSignals &signals);

    bool
    is_at_end() const
    {
      return part->flow->is_finished() || !events.what_has_come().empty();
    }

    /// Whether gates have moved beyond an edge of the mesh.
    bool
    have_gates_moved() const;

    /// Go on with ranks that have shared the cells out anew.
    void
    share_out_anew();

    /// Go on with the gates where they are now.
    void
    move_gates();

    /// Go on with a part in place of the present one.
    void
    hand_over_to(std::unique_ptr<Part<dim>> next);

    /// Leave a checkpoint. Collective.
    [[noreturn]] void
    stop(const int signal);

    const Parameters          &parameters;
    const CommandLine         &command_line;
    const MPI_Comm             communicator;
    Log                       &log;
    TimerOutput                timings;
    const Mesh<dim>            mesh; ///< with open outlets
    const Gates<dim>           gates;
    const Fingerprint          fingerprint;
    CheckpointWriter<dim>      checkpoints;
    StopEvents                 events;
    std::unique_ptr<Part<dim>> part;
  };
} // namespace Sandglass

#endif
