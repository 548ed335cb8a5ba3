#include <deal.II/base/mpi.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/output/fields.h>
#include <sandglass/output/observers.h>
#include <sandglass/output/output_directory.h>
#include <sandglass/output/replace_file.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <optional>
#include <sstream>
#include <utility>

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
    , scene(scene)
    , material(material)
    , walls(walls)
    , communicator(scene.communicator)
    , is_writer(Utilities::MPI::this_mpi_process(communicator) == 0)
    , log(log)
    , timings(timings)
    , history_times(parameters.history_interval)
    , field_times(parameters.interval)
    , checkpoint_times(parameters.checkpoint_interval)
    , progress(log, timings, parameters.progress_interval, end_time)
    , history(parameters, scene, material)
    , particles(parameters.directory, "particles", communicator)
    , grid(parameters.directory, "grid", communicator)
    , wall_tractions(parameters, scene, material, walls)
  {
    summary.n_ranks       = Utilities::MPI::n_mpi_processes(communicator);
    summary.n_cells       = scene.triangulation.n_active_cells();
    summary.has_flow_rate = SiloMeasures(scene).has_open_outlet;
  }



  void
  Observers::start(ParticleStage &stage, const StaticState *static_state)
  {
    if (static_state)
      summary.static_effort = static_state->effort;
    {
      TimerOutput::Scope scope(timings, Timing::output);
      open_files();
      observe_history(stage, true);
      summary.n_particles  = summary.totals.n_particles;
      summary.initial_mass = summary.totals.mass();
      observe_fields(stage,
                     static_state ? &static_state->wall_forces : nullptr);
    }
    write_summary("running");
    progress.start(stage.clock.time);
  }



  void
  Observers::resume(ParticleStage &stage, const Checkpoint &checkpoint)
  {
    restore(checkpoint, stage);
    go_on_from(checkpoint.observers, stage);
    progress.start(stage.clock.time);
  }



  void
  Observers::go_on_from(Observers &before, ParticleStage &stage)
  {
    before.finish_writing();
    go_on_from(before.archived(), stage);
    summary.static_effort = before.summary.static_effort;
    progress.go_on_from(before.progress);
  }



  void
  Observers::go_on_from(const std::string &archived, ParticleStage &stage)
  {
    {
      TimerOutput::Scope              scope(timings, Timing::output);
      std::istringstream              state(archived);
      boost::archive::binary_iarchive archive(state);
      archive >> *this;
      for (Schedule *times : {&history_times, &field_times, &checkpoint_times})
        times->pass(stage.clock.time);
      open_files();
      update_summary(stage.clock, ParticleTotals(stage, material.elasticity()));
    }
    write_summary("running");
  }



  std::string
  Observers::archived() const
  {
    std::ostringstream state;
    {
      boost::archive::binary_oarchive archive(state);
      archive << *this;
    }
    return state.str();
  }



  void
  Observers::after_step(ParticleStage &stage)
  {
    progress.after_step(stage.clock, summary.totals.n_particles);

    const double time              = stage.clock.time;
    const bool   history_is_due    = history_times.is_due(time);
    const bool   fields_are_due    = field_times.is_due(time);
    const bool   checkpoint_is_due = checkpoint_times.is_due(time);
    if (!history_is_due && !fields_are_due && !checkpoint_is_due)
      return;

    {
      TimerOutput::Scope scope(timings, Timing::output);
      if (history_is_due)
        observe_history(stage, fields_are_due);
      if (fields_are_due)
        {
          const auto forces = stage.contact.take_mean_forces();
          observe_fields(stage, &forces);
        }
      if (checkpoint_is_due)
        observe_checkpoint(stage);
    }
    if (fields_are_due)
      write_summary("running");
  }



  void
  Observers::finish(ParticleStage &stage)
  {
    {
      TimerOutput::Scope scope(timings, Timing::output);
      if (last_history_step != stage.clock.step)
        observe_history(stage, true);
      if (last_field_step != stage.clock.step)
        {
          const auto forces = stage.contact.take_mean_forces();
          observe_fields(stage, &forces);
        }
      if (parameters.checkpoint_interval > 0.)
        observe_checkpoint(stage);
      finish_writing();
    }
    write_summary("finished");
    timings.print_summary();
  }



  void
  Observers::finish_after_failure(const std::string &message)
  {
    try
      {
        writing.finish();
      }
    catch (const RunError &error)
      {
        log.record_error(error.what());
      }
    log.record_error(message);
    if (is_writer)
      write_summary_file("failed", message);
  }



  void
  Observers::open_files()
  {
    do_and_share_errors(communicator, [this]() {
      history.open();
      particles.open();
      grid.open();
      if (parameters.writes_walls)
        wall_tractions.open();
    });
  }



  void
  Observers::update_summary(const Clock &clock, const ParticleTotals &totals)
  {
    summary.clock       = clock;
    summary.totals      = totals;
    summary.peak_memory = Utilities::MPI::sum(peak_memory(), communicator);
  }



  void
  Observers::observe_history(ParticleStage &stage, const bool is_exact)
  {
    history_times.pass(stage.clock.time);
    last_history_step = stage.clock.step;

    const ParticleTotals totals(stage, material.elasticity());
    const FlowPattern    pattern(stage, history.stagnant_displacement());
    const double         critical_time_step =
      is_exact ? stage.critical_time_step() : stage.recent_critical_time_step();
    do_and_share_errors(communicator, [&]() {
      history.observe(stage.clock, critical_time_step, totals, pattern);
    });
    update_summary(stage.clock, totals);
  }



  void
  Observers::observe_fields(ParticleStage                &stage,
                            const std::vector<WallForce> *wall_forces)
  {
    field_times.pass(stage.clock.time);
    last_field_step = stage.clock.step;

    // Collecting is for all ranks together; writing is each rank's own, and the
    // run goes on meanwhile.
    std::vector<std::pair<FieldSeries *, VtuPiece>> pieces;
    if (parameters.writes_particles)
      pieces.emplace_back(&particles, particle_fields(stage));
    if (parameters.writes_grid)
      pieces.emplace_back(&grid, grid_fields(stage));
    std::optional<std::vector<WallTraction>> tractions;
    finish_writing();
    if (parameters.writes_walls && wall_forces != nullptr)
      tractions = wall_tractions.collect(*wall_forces);

    writing.start([this,
                   time      = stage.clock.time,
                   pieces    = std::move(pieces),
                   tractions = std::move(tractions)]() {
      for (const auto &[series, piece] : pieces)
        series->write(time, piece);
      if (tractions)
        wall_tractions.write(time, *tractions);
    });
  }



  void
  Observers::finish_writing()
  {
    do_and_share_errors(communicator, [this]() { writing.finish(); });
  }



  void
  Observers::observe_checkpoint(ParticleStage &stage)
  {
    checkpoint_times.pass(stage.clock.time);
    finish_writing();
    Checkpoint checkpoint = take_checkpoint(stage);
    do_and_share_errors(communicator, [&]() {
      if (!is_writer)
        return;
      checkpoint.observers = archived();
      write_checkpoint(
        parameters.directory,
        checkpoint_settings(scene, material, walls, stage.parameters),
        checkpoint);
    });
  }



  void
  Observers::write_summary(const std::string &status) const
  {
    do_and_share_errors(communicator, [&]() {
      if (is_writer)
        write_summary_file(status, "");
    });
  }



  void
  Observers::write_summary_file(const std::string &status,
                                const std::string &message) const
  {
    Summary complete = summary;
    if (complete.has_flow_rate)
      complete.flow = history.flow_summary();
    replace_file(parameters.directory + "/summary.json",
                 complete.to_json(status, message, timings));
  }
} // namespace Sandglass
