#include <sandglass/base/exceptions.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/run/simulation.h>
#include <sandglass/run/state_at_rest.h>
#include <sandglass/scene/make_mesh.h>

#include <sstream>
#include <utility>

namespace Sandglass
{
  template <int dim>
  Simulation<dim>::Simulation(const Parameters  &parameters,
                              const CommandLine &command_line,
                              const MPI_Comm     communicator,
                              Log               &log)
    : parameters(parameters)
    , command_line(command_line)
    , communicator(communicator)
    , log(log)
    // Times of this rank alone: otherwise deal.II adds a warning to each
    // error.
    , timings(log.stream(), TimerOutput::never, TimerOutput::wall_times)
    , mesh(timed_mesh())
    , gates(mesh, parameters.gates)
    , fingerprint(ParameterAcceptor::prm, mesh)
    , checkpoints(parameters.output, fingerprint, timings)
    , events(parameters.stop, parameters.gates, communicator)
    , part(make_part({}, gates.closed_at(0.)))
  {}



  template <int dim>
  Mesh<dim>
  Simulation<dim>::timed_mesh()
  {
    TimerOutput::Scope       scope(timings, Timing::set_up);
    std::vector<std::string> warnings;
    Mesh<dim>                result =
      make_mesh<dim>(parameters.scene, communicator, &warnings);
    log.stream() << "Mesh: " << result.cells.size() << " cells, "
                 << to_text(parameters.scene.resolution()) << std::endl;
    log.warn(warnings);
    return result;
  }



  template <int dim>
  std::unique_ptr<Part<dim>>
  Simulation<dim>::make_part(const std::vector<unsigned int> &cell_weights,
                             const std::vector<bool>         &closed_faces)
  {
    TimerOutput::Scope scope(timings, Timing::set_up);
    return std::make_unique<Part<dim>>(parameters,
                                       gates.are_on() ?
                                         gates.close(closed_faces) :
                                         mesh,
                                       closed_faces,
                                       cell_weights,
                                       communicator,
                                       log,
                                       timings);
  }



  template <int dim>
  RunResult
  Simulation<dim>::run(OutputDirectory             &directory,
                       const std::function<void()> &before_writing)
  {
    const std::optional<CheckpointPlace> place = checkpoint_place();
    std::optional<Checkpoint>            checkpoint;
    if (place)
      checkpoint = find_checkpoint(*place);
    if (before_writing)
      before_writing();
    if (place)
      directory.go_on(place->directory, log);
    else
      directory.start(log);
    StopSignals signals(communicator);
    try
      {
        directory.write_parameters();
        if (checkpoint)
          log.stream() << "Goes on from " << place->file
                       << ", t = " << checkpoint->time << " s" << std::endl;
        return run_to_end(checkpoint, signals);
      }
    catch (const RunStopped &)
      {
        throw;
      }
    catch (const RunError &error)
      {
        part->observers.finish_after_failure(error.what());
        throw;
      }
    catch (const std::exception &error)
      {
        // Perhaps on this rank only.
        const std::string message = message_of(error);
        part->observers.finish_after_failure(message);
        throw std::runtime_error(message);
      }
  }



  template <int dim>
  std::optional<CheckpointPlace>
  Simulation<dim>::checkpoint_place() const
  {
    if (!command_line.is_restart)
      return {};
    return CheckpointPlace(command_line.restart_from.empty() ?
                             parameters.output.directory :
                             command_line.restart_from);
  }



  template <int dim>
  Checkpoint
  Simulation<dim>::find_checkpoint(const CheckpointPlace &place)
  {
    Checkpoint checkpoint =
      read_checkpoint(place, fingerprint, parameters.particle_stage.end_time);
    if (checkpoint.cell_weights != part->scene.cell_weights ||
        checkpoint.closed_faces != part->closed_faces)
      part = make_part(checkpoint.cell_weights, checkpoint.closed_faces);
    part->observers.refuse_other_tables(checkpoint.observers, place.directory);
    return checkpoint;
  }



  template <int dim>
  RunResult
  Simulation<dim>::run_to_end(const std::optional<Checkpoint> &checkpoint,
                              StopSignals                     &signals)
  {
    if (checkpoint)
      go_on_from(*checkpoint);
    else
      start(signals);
    flow_to_end(signals);
    part->observers.observe_end(part->flow->view());
    part->observers.finish(events.what_has_come());
    // From which a later end can be reached; killed before it, the run has
    // finished, and an earlier one does as well.
    checkpoints.at_end(*part);
    return {part->observers.what_happened(), part->observers.discharge()};
  }



  template <int dim>
  void
  Simulation<dim>::start(StopSignals &signals)
  {
    Observers<dim> &observers = part->observers;
    observers.begin(part->flow->view());
    const std::optional<AtRest> at_rest =
      find_state_at_rest(parameters, *part, log, timings, [&]() {
        const int signal = signals.now();
        if (signal == 0)
          return;
        const std::string message =
          "Stopped by " + name_of_signal(signal) +
          " before the state at rest was found; there is no checkpoint yet, "
          "so run it again.";
        observers.stop(part->flow->view(), message);
        throw RunStopped(message, signal);
      });
    observers.start(part->flow->view(), at_rest ? &*at_rest : nullptr);
  }



  template <int dim>
  void
  Simulation<dim>::stop(const int signal)
  {
    checkpoints.at_stop(*part);
    std::ostringstream message;
    message << "Stopped by " << name_of_signal(signal)
            << " at t = " << part->flow->view().clock().time
            << " s; go on with --restart.";
    part->observers.stop(part->flow->view(), message.str());
    throw RunStopped(message.str(), signal);
  }



  template <int dim>
  void
  Simulation<dim>::go_on_from(const Checkpoint &checkpoint)
  {
    part->go_on_from(checkpoint);
    checkpoints.pass(checkpoint.time);
    events.go_on_from(part->observers);
  }



  template <int dim>
  void
  Simulation<dim>::flow_to_end(StopSignals &signals)
  {
    for (flow_on_part(signals); !is_at_end(); flow_on_part(signals))
      if (have_gates_moved())
        move_gates();
      else
        share_out_anew();
  }



  template <int dim>
  bool
  Simulation<dim>::have_gates_moved() const
  {
    return gates.are_on() && gates.closed_at(part->flow->view().clock().time) !=
                               part->closed_faces;
  }



  template <int dim>
  void
  Simulation<dim>::share_out_anew()
  {
    log.stream() << "t = " << part->flow->view().clock().time
                 << " s: ranks share the cells out anew" << std::endl;
    hand_over_to(
      make_part(cell_weights(*part->flow, communicator), part->closed_faces));
  }



  template <int dim>
  void
  Simulation<dim>::move_gates()
  {
    const double time = part->flow->view().clock().time;
    log.stream() << "t = " << time << " s: gates move" << std::endl;
    hand_over_to(make_part(part->scene.cell_weights, gates.closed_at(time)));
    // Walls have come or gone.
    part->flow->start_wall_records_anew();
    part->observers.start_wall_means_anew();
  }



  template <int dim>
  void
  Simulation<dim>::hand_over_to(std::unique_ptr<Part<dim>> next)
  {
    next->go_on_from(*part);
    part = std::move(next);
  }



  template <int dim>
  void
  Simulation<dim>::flow_on_part(StopSignals &signals)
  {
    Flow &flow = *part->flow;
    // Balance and gates are looked at before a step, so that a run that goes on
    // from a checkpoint sees what the first run saw after writing it.
    while (!is_at_end() && !have_gates_moved() &&
           !part->balance.is_lost(flow, communicator))
      {
        {
          TimerOutput::Scope scope(timings, Timing::particle_loop);
          flow.step();
        }
        part->observers.after_step(flow.view());
        events.after_step(part->observers);
        checkpoints.after_step(*part);
        if (const int signal = signals.after_step())
          stop(signal);
      }
  }



#define INSTANTIATE(dim) template class Simulation<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
