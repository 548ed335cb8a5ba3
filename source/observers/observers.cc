#include <deal.II/base/mpi.h>

#include <sandglass/observers/fields.h>
#include <sandglass/observers/observers.h>
#include <sandglass/observers/output_directory.h>
#include <sandglass/observers/replace_file.h>

namespace Sandglass
{
  Observers::Observers(const OutputParameters   &parameters,
                       const Scene              &scene,
                       const MaterialParameters &material,
                       const WallParameters     &walls,
                       const double              end_time,
                       Log                      &log,
                       TimerOutput              &timings)
    : parameters(parameters)
    , communicator(scene.communicator)
    , is_writer(Utilities::MPI::this_mpi_process(scene.communicator) == 0)
    , elasticity(material.elasticity())
    , log(log)
    , timings(timings)
    , history_times(parameters.history_interval)
    , field_times(parameters.interval)
    , progress(log, parameters.progress_interval, end_time)
    , history(parameters, scene, material)
  {
    summary.n_ranks       = Utilities::MPI::n_mpi_processes(communicator);
    summary.n_cells       = scene.triangulation.n_active_cells();
    summary.has_flow_rate = SiloMeasures(scene).has_open_outlet;
    if (parameters.writes_particles)
      particles.emplace(parameters.directory, "particles", communicator);
    if (parameters.writes_grid)
      grid.emplace(parameters.directory, "grid", communicator);
    if (parameters.writes_walls)
      wall_tractions.emplace(parameters, scene, material, walls);
  }



  void
  Observers::start(ParticleStage                &stage,
                   const std::vector<WallForce> *static_wall_forces)
  {
    {
      TimerOutput::Scope scope(timings, Timing::output);
      do_and_share_errors(communicator, [this]() {
        history.open();
        if (wall_tractions)
          wall_tractions->open();
      });
      observe_history(stage);
      summary.n_particles  = summary.totals.n_particles;
      summary.initial_mass = summary.totals.mass();
      observe_fields(stage);
      if (wall_tractions && static_wall_forces != nullptr)
        observe_walls(stage.clock, *static_wall_forces);
    }
    write_summary("running");
    progress.start(stage.clock.time);
  }



  void
  Observers::after_step(ParticleStage &stage)
  {
    progress.after_step(stage.clock, summary.totals.n_particles);

    const double time           = stage.clock.time;
    const bool   history_is_due = history_times.is_due(time);
    const bool   fields_are_due = field_times.is_due(time);
    if (!history_is_due && !fields_are_due)
      return;

    TimerOutput::Scope scope(timings, Timing::output);
    if (history_is_due)
      observe_history(stage);
    if (fields_are_due)
      {
        observe_fields(stage);
        if (wall_tractions)
          observe_walls(stage.clock, stage.contact.take_mean_forces());
        scope.stop();
        write_summary("running");
      }
  }



  void
  Observers::finish(ParticleStage &stage)
  {
    {
      TimerOutput::Scope scope(timings, Timing::output);
      if (last_history_step != stage.clock.step)
        observe_history(stage);
      if (last_field_step != stage.clock.step)
        {
          observe_fields(stage);
          if (wall_tractions)
            observe_walls(stage.clock, stage.contact.take_mean_forces());
        }
    }
    write_summary("finished");
    timings.print_summary();
  }



  void
  Observers::finish_after_failure(const std::string &message)
  {
    log.record_error(message);
    if (is_writer)
      replace_file(parameters.directory + "/summary.json",
                   summary.to_json("failed", message, timings));
  }



  void
  Observers::observe_history(ParticleStage &stage)
  {
    history_times.pass(stage.clock.time);
    last_history_step = stage.clock.step;

    summary.clock       = stage.clock;
    summary.totals      = ParticleTotals(stage, elasticity);
    summary.peak_memory = Utilities::MPI::sum(peak_memory(), communicator);
    const double critical_time_step = stage.critical_time_step();
    do_and_share_errors(communicator, [&]() {
      history.observe(stage.clock, critical_time_step, summary.totals);
    });
    summary.flow_rate_plateau = history.flow_rate_plateau();
  }



  void
  Observers::observe_fields(ParticleStage &stage)
  {
    field_times.pass(stage.clock.time);
    last_field_step = stage.clock.step;

    const double time = stage.clock.time;
    if (particles)
      {
        const VtuPiece piece = particle_fields(stage);
        do_and_share_errors(communicator,
                            [&]() { particles->write(time, piece); });
      }
    if (grid)
      {
        const VtuPiece piece = grid_fields(stage);
        do_and_share_errors(communicator, [&]() { grid->write(time, piece); });
      }
  }



  void
  Observers::observe_walls(const Clock                  &clock,
                           const std::vector<WallForce> &forces)
  {
    const auto tractions = wall_tractions->collect(forces);
    do_and_share_errors(communicator, [&]() {
      wall_tractions->write(clock.time, tractions);
    });
  }



  void
  Observers::write_summary(const std::string &status) const
  {
    do_and_share_errors(communicator, [&]() {
      if (is_writer)
        replace_file(parameters.directory + "/summary.json",
                     summary.to_json(status, "", timings));
    });
  }
} // namespace Sandglass
