#include <sandglass/base/exceptions.h>
#include <sandglass/choices.h>
#include <sandglass/output/banner.h>
#include <sandglass/output/output_directory.h>
#include <sandglass/run/checkpoint_writer.h>
#include <sandglass/run/part.h>
#include <sandglass/run/run.h>
#include <sandglass/run/state_at_rest.h>
#include <sandglass/scene/make_mesh.h>

#include <optional>
#include <sstream>

namespace Sandglass
{
  namespace
  {
    /// One simulation in a space dimension.
    template <int dim>
    class Simulation
    {
    public:
      /// Read the input; nothing is written yet.
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

      std::unique_ptr<Part<dim>>
      make_part(const std::vector<unsigned int> &cell_weights);

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

      /// Run to the end. Ranks share the cells out anew where they should.
      void
      flow_to_end(StopSignals &signals);

      /// Run to the end, or until the ranks should share the cells out anew.
      void
      flow_on_partition(StopSignals &signals);

      /// Leave a checkpoint. Collective.
      [[noreturn]] void
      stop(const int signal);

      const Parameters          &parameters;
      const CommandLine         &command_line;
      const MPI_Comm             communicator;
      Log                       &log;
      TimerOutput                timings;
      const Mesh<dim>            mesh;
      const Fingerprint          fingerprint;
      CheckpointWriter<dim>      checkpoints;
      std::unique_ptr<Part<dim>> part;
    };



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
      , fingerprint(ParameterAcceptor::prm, mesh)
      , checkpoints(parameters.output, fingerprint, timings)
      , part(make_part({}))
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
    Simulation<dim>::make_part(const std::vector<unsigned int> &cell_weights)
    {
      TimerOutput::Scope scope(timings, Timing::set_up);
      return std::make_unique<Part<dim>>(
        parameters, mesh, cell_weights, communicator, log, timings);
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
      if (checkpoint.cell_weights != part->scene.cell_weights)
        part = make_part(checkpoint.cell_weights);
      part->observers.refuse_other_tables(checkpoint.observers,
                                          place.directory);
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
      part->observers.finish();
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
    }



    template <int dim>
    void
    Simulation<dim>::flow_to_end(StopSignals &signals)
    {
      for (flow_on_partition(signals); !part->flow->is_finished();
           flow_on_partition(signals))
        {
          log.stream() << "t = " << part->flow->view().clock().time
                       << " s: ranks share the cells out anew" << std::endl;
          auto next = make_part(cell_weights(*part->flow, communicator));
          next->go_on_from(*part);
          part = std::move(next);
        }
    }



    template <int dim>
    void
    Simulation<dim>::flow_on_partition(StopSignals &signals)
    {
      Flow &flow = *part->flow;
      // The balance is looked at before a step, so that a run that goes on from
      // a checkpoint sees what the first run saw after writing it.
      while (!flow.is_finished() && !part->balance.is_lost(flow, communicator))
        {
          {
            TimerOutput::Scope scope(timings, Timing::particle_loop);
            flow.step();
          }
          part->observers.after_step(flow.view());
          checkpoints.after_step(*part);
          if (const int signal = signals.after_step())
            stop(signal);
        }
    }
  } // namespace



  std::optional<RunResult>
  run(const Parameters               &parameters,
      const CommandLine              &command_line,
      const std::vector<std::string> &warnings,
      const MPI_Comm                  communicator,
      Log                            &log,
      const std::function<void()>    &before_writing)
  {
    const bool only_checks = command_line.task == CommandLine::Task::validate;
    std::optional<RunResult>       result;
    std::optional<OutputDirectory> directory;
    if (!only_checks)
      {
        log.stream() << banner(communicator) << std::flush;
        directory.emplace(parameters.output.directory, communicator);
      }
    log.warn(warnings);
    choose(
      AllKinematics(),
      [&parameters](const auto kinematics) {
        return decltype(kinematics)::Type::formulation ==
               parameters.scene.formulation;
      },
      [&](const auto kinematics) {
        constexpr int   dim = decltype(kinematics)::Type::dim;
        Simulation<dim> simulation(parameters, command_line, communicator, log);
        if (directory)
          result.emplace(simulation.run(*directory, before_writing));
      });
    return result;
  }
} // namespace Sandglass
