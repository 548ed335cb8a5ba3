#include <sandglass/base/exceptions.h>
#include <sandglass/observers/banner.h>
#include <sandglass/observers/observers.h>
#include <sandglass/observers/output_directory.h>
#include <sandglass/run/run.h>
#include <sandglass/run/static_to_particles.h>
#include <sandglass/scene/make_mesh.h>
#include <sandglass/static_stage/static_stage.h>

#include <optional>

namespace Sandglass
{
  namespace
  {
    Scene
    make_scene(const SceneParameters &parameters, const MPI_Comm communicator)
    {
      return {make_mesh(parameters, communicator),
              parameters.formulation,
              parameters.particles_per_cell,
              parameters.gravity,
              communicator};
    }



    /// Find the state at rest and carry it to the particles; returns the forces
    /// on the walls, or nothing where the parameters leave this stage out.
    std::optional<std::vector<WallForce>>
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
      const StaticState  state = static_stage.run();
      carry_to_particles(state,
                         stage,
                         parameters.static_stage.displaces_particles);
      static_scope.stop();
      if (parameters.output.writes_grid)
        {
          TimerOutput::Scope output_scope(timings, Timing::output);
          static_stage.write_vtu(parameters.output.directory);
        }
      return state.wall_forces;
    }



    void
    flow(ParticleStage &stage, Observers &observers, TimerOutput &timings)
    {
      while (!stage.is_finished())
        {
          {
            TimerOutput::Scope scope(timings, Timing::particle_loop);
            stage.step();
          }
          observers.after_step(stage);
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
    timings.enter_subsection(Timing::set_up);
    const Scene scene = make_scene(parameters.scene, communicator);
    const std::unique_ptr<ParticleStage> stage = make_particle_stage(
      scene, parameters.material, parameters.walls, parameters.particle_stage);
    timings.leave_subsection();

    std::optional<Checkpoint> checkpoint;
    if (command_line.is_restart)
      checkpoint =
        read_checkpoint(parameters.output.directory,
                        checkpoint_settings(scene,
                                            parameters.material,
                                            parameters.walls,
                                            parameters.particle_stage));

    prepare_output_directory(parameters.output,
                             command_line.is_restart,
                             communicator,
                             log);
    Observers observers(parameters.output,
                        scene,
                        parameters.material,
                        parameters.walls,
                        parameters.particle_stage.end_time,
                        log,
                        timings);
    try
      {
        if (checkpoint)
          observers.resume(*stage, *checkpoint);
        else
          {
            const auto wall_forces = rest(parameters, *stage, log, timings);
            observers.start(*stage, wall_forces ? &*wall_forces : nullptr);
          }
        flow(*stage, observers, timings);
        observers.finish(*stage);
      }
    catch (const RunError &error)
      {
        observers.finish_after_failure(error.what());
        throw;
      }
  }
} // namespace Sandglass
