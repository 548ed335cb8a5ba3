#include <deal.II/base/mpi.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/output/closing_lines.h>
#include <sandglass/output/observers.h>
#include <sandglass/output/output_directory.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <sstream>
#include <utility>

namespace Sandglass
{
  template <int dim>
  Observers<dim>::Observers(const OutputParameters   &parameters,
                            const Scene<dim>         &scene,
                            const Resolution         &resolution,
                            const MaterialParameters &material,
                            const double              end_time,
                            const bool                is_fed,
                            Log                      &log,
                            TimerOutput              &timings)
    : parameters(parameters)
    , communicator(scene.communicator)
    , symmetry_factor(scene.symmetry_factor)
    , layers{scene.fill_bottom, scene.fill_top}
    , is_writer(Utilities::MPI::this_mpi_process(communicator) == 0)
    , log(log)
    , timings(timings)
    , history_times(parameters.history_interval)
    , field_times(parameters.interval)
    , progress(log, timings, parameters.progress_interval, end_time)
    , history(parameters, scene, material, is_fed)
    , particles(parameters.directory, "particles", communicator)
    , grid(parameters.directory, "grid", communicator)
    , wall_tractions(parameters, scene, material)
    , design(parameters, scene)
  {
    summary.formulation   = scene.formulation;
    summary.n_ranks       = Utilities::MPI::n_mpi_processes(communicator);
    summary.n_cells       = scene.triangulation.n_active_cells();
    summary.resolution    = resolution;
    summary.has_flow_rate = SiloMeasures<dim>(scene).has_open_outlet;
    summary.is_fed        = is_fed;
    for (const Wall<dim> &wall : scene.walls)
      summary.has_moving_walls =
        summary.has_moving_walls || wall.velocity.norm() > 0.;
  }



  template <int dim>
  void
  Observers<dim>::begin(const FlowView &view)
  {
    update_summary(view.clock(), totals(view));
    summary.n_particles  = summary.totals.n_particles;
    summary.initial_mass = summary.totals.mass();
    write_summary(Status::running);
  }



  template <int dim>
  void
  Observers<dim>::start(const FlowView &view, const AtRest *at_rest)
  {
    if (at_rest != nullptr)
      summary.static_effort = at_rest->effort;
    {
      TimerOutput::Scope scope(timings, Timing::output);
      open_files();
      std::vector<WallTraction> tractions;
      if (at_rest != nullptr &&
          (parameters.writes_walls || design.needs_tractions()))
        tractions = wall_tractions.at_rest(at_rest->wall_records);
      observe_history(view, true, tractions);
      summary.n_particles  = summary.totals.n_particles;
      summary.initial_mass = summary.totals.mass();
      if (!parameters.writes_walls)
        tractions.clear();
      largest_pressure.add(tractions, summary.has_flow_rate);
      design.add_walls(tractions, 1.);
      observe_fields(view, std::move(tractions));
    }
    write_summary(Status::running);
    progress.start(view.clock().time);
  }



  template <int dim>
  void
  Observers<dim>::refuse_other_tables(const std::string &archived,
                                      const std::string &directory)
  {
    const std::string message = shared_error(communicator, [&]() {
      load(archived);
      history.refuse_other(directory);
      wall_tractions.refuse_other(directory);
      if (is_writer)
        design.refuse_other(directory);
    });
    if (!message.empty())
      throw InputError(message, "Output", "Directory");
  }



  template <int dim>
  void
  Observers<dim>::go_on_from(const std::string &archived, const FlowView &view)
  {
    restore(archived, view);
    progress.start(view.clock().time);
  }



  template <int dim>
  void
  Observers<dim>::go_on_from(Observers      &before,
                             const FlowView &view_before,
                             const FlowView &view)
  {
    summary.static_effort = before.summary.static_effort;
    particle_steps_before = before.totals(view_before).particle_steps;
    restore(before.archived(), view);
    progress.go_on_from(before.progress);
  }



  template <int dim>
  void
  Observers<dim>::load(const std::string &archived)
  {
    std::istringstream              state(archived);
    boost::archive::binary_iarchive archive(state);
    archive >> *this;
  }



  template <int dim>
  void
  Observers<dim>::restore(const std::string &archived, const FlowView &view)
  {
    {
      TimerOutput::Scope scope(timings, Timing::output);
      load(archived);
      for (Schedule *times : {&history_times, &field_times})
        times->pass(view.clock().time);
      open_files();
      update_summary(view.clock(), totals(view));
    }
    write_summary(Status::running);
  }



  template <int dim>
  std::string
  Observers<dim>::archived()
  {
    finish_writing();
    std::ostringstream state;
    {
      boost::archive::binary_oarchive archive(state);
      archive << std::as_const(*this);
    }
    return state.str();
  }



  template <int dim>
  void
  Observers<dim>::after_step(const FlowView &view)
  {
    const double time = view.clock().time;
    progress.after_step(view.clock(), summary.totals.n_particles);

    const bool history_is_due = history_times.is_due(time);
    const bool fields_are_due = field_times.is_due(time);
    if (!history_is_due && !fields_are_due)
      return;

    {
      TimerOutput::Scope scope(timings, Timing::output);
      if (history_is_due)
        observe_history(view, fields_are_due);
      if (fields_are_due)
        observe_fields(view, observe_walls(view));
    }
    if (fields_are_due)
      write_summary(Status::running);
  }



  template <int dim>
  void
  Observers<dim>::observe_end(const FlowView &view)
  {
    TimerOutput::Scope scope(timings, Timing::output);
    const auto         step = view.clock().step;
    if (last_history_step != step)
      observe_history(view, true);
    if (last_field_step != step)
      observe_fields(view, observe_walls(view));
    finish_writing();
  }



  template <int dim>
  void
  Observers<dim>::finish(const std::string &event)
  {
    summary.ended_by = event.empty() ? "the end time has come" : event;
    write_summary(Status::finished);
    timings.print_summary();
    if (log.stream().is_active())
      log.stream() << closing_lines(summary,
                                    history.beverloo_rates(),
                                    parameters.directory)
                   << std::flush;
  }



  template <int dim>
  void
  Observers<dim>::stop(const FlowView &view, const std::string &message)
  {
    finish_writing();
    update_summary(view.clock(), totals(view));
    write_summary(Status::stopped, message);
    log.record_error(message);
  }



  template <int dim>
  void
  Observers<dim>::finish_after_failure(const std::string &message)
  {
    try
      {
        writing.finish();
      }
    catch (const std::exception &error)
      {
        log.record_error(message_of(error));
      }
    log.record_error(message);
    try
      {
        if (is_writer)
          write_summary_on_rank(Status::failed, message);
        else
          amend_summary_file(parameters.directory,
                             Status::failed,
                             message,
                             Utilities::MPI::this_mpi_process(communicator));
      }
    catch (const std::exception &error)
      {
        // The first failure is the one to tell.
        log.record_error(message_of(error));
      }
  }



#define INSTANTIATE(dim) template class Observers<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
