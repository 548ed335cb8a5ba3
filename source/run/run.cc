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
      Simulation(const Parameters &parameters,
                 const bool        is_restart,
                 const MPI_Comm    communicator,
                 Log              &log);

      RunResult
      run();

    private:
      Mesh<dim>
      timed_mesh();

      std::unique_ptr<Part<dim>>
      make_part(const std::vector<unsigned int> &cell_weights);

      /// The checkpoint to go on from, if the command line asks for that; the
      /// part is then on its partition.
      std::optional<Checkpoint>
      find_checkpoint();

      void
      start();

      void
      go_on_from(const Checkpoint &checkpoint);

      /// Run to the end. Ranks share the cells out anew where they should.
      void
      flow_to_end();

      /// Run to the end, or until the ranks should share the cells out anew.
      void
      flow_on_partition();

      const Parameters          &parameters;
      const bool                 is_restart;
      const MPI_Comm             communicator;
      Log                       &log;
      TimerOutput                timings;
      const Mesh<dim>            mesh;
      const Fingerprint          fingerprint;
      CheckpointWriter<dim>      checkpoints;
      std::unique_ptr<Part<dim>> part;
    };



    template <int dim>
    Simulation<dim>::Simulation(const Parameters &parameters,
                                const bool        is_restart,
                                const MPI_Comm    communicator,
                                Log              &log)
      : parameters(parameters)
      , is_restart(is_restart)
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
    Simulation<dim>::run()
    {
      const std::optional<Checkpoint> checkpoint = find_checkpoint();
      prepare_output_directory(parameters.output,
                               is_restart,
                               communicator,
                               log);
      try
        {
          if (checkpoint)
            go_on_from(*checkpoint);
          else
            start();
          flow_to_end();
          part->observers.observe_end(part->flow->view());
          checkpoints.at_end(*part);
          part->observers.finish();
          return {part->observers.what_happened(), part->observers.discharge()};
        }
      catch (const RunError &error)
        {
          part->observers.finish_after_failure(error.what());
          throw;
        }
    }



    template <int dim>
    std::optional<Checkpoint>
    Simulation<dim>::find_checkpoint()
    {
      if (!is_restart)
        return {};
      const Checkpoint checkpoint =
        read_checkpoint(parameters.output.directory,
                        fingerprint,
                        parameters.particle_stage.end_time);
      if (checkpoint.cell_weights != part->scene.cell_weights)
        part = make_part(checkpoint.cell_weights);
      return checkpoint;
    }



    template <int dim>
    void
    Simulation<dim>::start()
    {
      const std::optional<AtRest> at_rest =
        find_state_at_rest(parameters, *part, log, timings);
      part->observers.start(part->flow->view(), at_rest ? &*at_rest : nullptr);
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
    Simulation<dim>::flow_to_end()
    {
      for (flow_on_partition(); !part->flow->is_finished(); flow_on_partition())
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
    Simulation<dim>::flow_on_partition()
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
        }
    }
  } // namespace



  std::optional<RunResult>
  run(const Parameters               &parameters,
      const CommandLine              &command_line,
      const std::vector<std::string> &warnings,
      const MPI_Comm                  communicator,
      Log                            &log)
  {
    const bool only_checks = command_line.task == CommandLine::Task::validate;
    std::optional<RunResult> result;
    if (!only_checks)
      log.stream() << banner(communicator) << std::flush;
    log.warn(warnings);
    choose(
      AllKinematics(),
      [&parameters](const auto kinematics) {
        return decltype(kinematics)::Type::formulation ==
               parameters.scene.formulation;
      },
      [&](const auto kinematics) {
        constexpr int   dim = decltype(kinematics)::Type::dim;
        Simulation<dim> simulation(parameters,
                                   command_line.is_restart,
                                   communicator,
                                   log);
        if (!only_checks)
          result.emplace(simulation.run());
      });
    return result;
  }
} // namespace Sandglass
