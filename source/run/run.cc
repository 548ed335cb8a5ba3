#include <sandglass/base/exceptions.h>
#include <sandglass/output/banner.h>
#include <sandglass/output/observers.h>
#include <sandglass/output/output_directory.h>
#include <sandglass/run/load_balance.h>
#include <sandglass/run/run.h>
#include <sandglass/run/static_to_particles.h>
#include <sandglass/scene/make_mesh.h>
#include <sandglass/flow/updated_lagrangian/static_stage.h>

#include <optional>

namespace Sandglass
{
  namespace
  {
    /// What works on one partition of the mesh.
    struct Part
    {
      Part(const Parameters                &parameters,
           const Mesh                      &mesh,
           const std::vector<unsigned int> &cell_weights,
           const MPI_Comm                   communicator,
           Log                             &log,
           TimerOutput                     &timings)
        : scene(mesh,
                parameters.scene.formulation,
                parameters.scene.particles_per_cell,
                parameters.scene.gravity,
                communicator,
                parameters.scene.partitioner,
                cell_weights)
        , stage(make_particle_stage(scene,
                                    parameters.material,
                                    parameters.walls,
                                    parameters.particle_stage))
        , observers(parameters.output,
                    scene,
                    parameters.material,
                    parameters.walls,
                    parameters.particle_stage.end_time,
                    log,
                    timings)
      {}

      const Scene                          scene;
      const std::unique_ptr<ParticleStage> stage;
      Observers                            observers;
    };



    /// Find the state at rest and carry it to the particles; returns it, or
    /// nothing where the parameters leave this stage out.
    std::optional<StaticState>
    rest(const Parameters &parameters,
         ParticleStage    &stage,
         Log              &log,
         TimerOutput      &timings)
    {
      if (!parameters.static_stage.is_enabled)
        return {};
      TimerOutput::Scope static_scope(timings, Timing::static_stage);
      StaticStage        static_stage(stage.scene,
                               parameters.material,
                               parameters.walls,
                               parameters.static_stage,
                               log.stream());
      StaticState        state = static_stage.run();
      carry_to_particles(state,
                         stage,
                         parameters.static_stage.displaces_particles);
      static_scope.stop();
      if (parameters.output.writes_grid)
        {
          TimerOutput::Scope output_scope(timings, Timing::output);
          static_stage.write_vtu(parameters.output.directory);
        }
      return state;
    }



    /// To the end, or until the ranks should share the cells out anew.
    void
    flow(Part &part, TimerOutput &timings)
    {
      // Looked at before a step, so that a run that goes on from a checkpoint
      // looks at what the first run has looked at after writing it.
      while (!part.stage->is_finished() && !is_balance_lost(*part.stage))
        {
          {
            TimerOutput::Scope scope(timings, Timing::particle_loop);
            part.stage->step();
          }
          part.observers.after_step(*part.stage);
        }
    }



    /// To the end. Where ranks should, they share the cells out anew.
    template <typename MakePart>
    void
    flow_to_end(std::unique_ptr<Part> &part,
                const MakePart        &make_part,
                Log                   &log,
                TimerOutput           &timings)
    {
      for (flow(*part, timings); !part->stage->is_finished();
           flow(*part, timings))
        {
          log.stream() << "t = " << part->stage->clock.time
                       << " s: ranks share the cells out anew" << std::endl;
          auto next = make_part(cell_weights(*part->stage));
          hand_over(*part->stage, *next->stage);
          next->observers.go_on_from(part->observers, *next->stage);
          part = std::move(next);
        }
    }
  } // namespace



  void
  run(const Parameters  &parameters,
      const CommandLine &command_line,
      const MPI_Comm     communicator)
  {
    Log log(communicator, command_line.is_quiet);
    log.stream() << banner(communicator) << std::flush;

    // Of this rank alone: otherwise deal.II adds a warning to each error.
    TimerOutput timings(log.stream(),
                        TimerOutput::never,
                        TimerOutput::wall_times);
    const Mesh  mesh = [&]() {
      TimerOutput::Scope scope(timings, Timing::set_up);
      return make_mesh(parameters.scene, communicator);
    }();
    const auto make_part = [&](const std::vector<unsigned int> &weights) {
      TimerOutput::Scope scope(timings, Timing::set_up);
      return std::make_unique<Part>(
        parameters, mesh, weights, communicator, log, timings);
    };
    std::unique_ptr<Part> part = make_part({});

    std::optional<Checkpoint> checkpoint;
    if (command_line.is_restart)
      {
        checkpoint =
          read_checkpoint(parameters.output.directory,
                          checkpoint_settings(part->scene,
                                              parameters.material,
                                              parameters.walls,
                                              parameters.particle_stage));
        if (checkpoint->cell_weights != part->scene.cell_weights)
          part = make_part(checkpoint->cell_weights);
      }

    prepare_output_directory(parameters.output,
                             command_line.is_restart,
                             communicator,
                             log);
    try
      {
        if (checkpoint)
          part->observers.resume(*part->stage, *checkpoint);
        else
          {
            const auto static_state =
              rest(parameters, *part->stage, log, timings);
            part->observers.start(*part->stage,
                                  static_state ? &*static_state : nullptr);
          }
        flow_to_end(part, make_part, log, timings);
        part->observers.finish(*part->stage);
      }
    catch (const RunError &error)
      {
        part->observers.finish_after_failure(error.what());
        throw;
      }
  }
} // namespace Sandglass
