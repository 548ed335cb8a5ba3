// What observers write, and when it is written.

#include <deal.II/base/mpi.h>

#include <sandglass/choices/dimensions.h>
#include <sandglass/output/grid_fields.h>
#include <sandglass/output/json_object.h>
#include <sandglass/output/observers.h>
#include <sandglass/output/output_directory.h>

#include <cmath>
#include <utility>

namespace Sandglass
{
  template <int dim>
  void
  Observers<dim>::open_files()
  {
    do_and_share_errors(communicator, [this]() {
      history.open();
      particles.open();
      grid.open();
      if (parameters.writes_walls)
        wall_tractions.open();
      if (is_writer)
        design.open();
    });
  }



  template <int dim>
  SiloTotals
  Observers<dim>::totals(const FlowView &view) const
  {
    SiloTotals result(view.totals(), symmetry_factor);
    result.particle_steps += particle_steps_before;
    return result;
  }



  template <int dim>
  void
  Observers<dim>::update_summary(const Clock &clock, const SiloTotals &totals)
  {
    summary.clock       = clock;
    summary.totals      = totals;
    summary.peak_memory = Utilities::MPI::sum(peak_memory(), communicator);
  }



  template <int dim>
  void
  Observers<dim>::observe_history(const FlowView &view, const bool is_exact)
  {
    observe_history(view,
                    is_exact,
                    design.needs_tractions() ?
                      wall_tractions.since(design.wall_sums,
                                           view.clock().time,
                                           view.wall_records()) :
                      std::vector<WallTraction>());
  }



  template <int dim>
  void
  Observers<dim>::observe_history(const FlowView                  &view,
                                  const bool                       is_exact,
                                  const std::vector<WallTraction> &tractions)
  {
    const Clock &clock = view.clock();
    history_times.pass(clock.time);
    last_history_step = clock.step;

    const HistoryRow row{clock,
                         view.critical_time_step(is_exact),
                         totals(view),
                         {view,
                          history.stagnant_displacement(),
                          symmetry_factor,
                          communicator,
                          design.looks_at_particles() ?
                            [this](const ParticleRecord &particle) {
                              design.add(particle);
                            } :
                            std::function<void(const ParticleRecord &)>()},
                         summary.is_fed,
                         summary.has_moving_walls};
    design.end_row(clock.time);
    do_and_share_errors(communicator, [&]() {
      history.add(row);
      if (is_writer)
        design.write_row(clock.time, tractions);
    });
    check_dissipation(summary.totals, row);
    update_summary(clock, row.totals);
  }



  template <int dim>
  void
  Observers<dim>::check_dissipation(const SiloTotals &before,
                                    const HistoryRow &row)
  {
    constexpr double rounding = 1e-10;

    const double fall = before.dissipated_energy - row.totals.dissipated_energy;
    if (!row.totals.dissipation_can_fall &&
        fall > rounding * std::abs(before.dissipated_energy))
      log.stream() << "Warning: by t = " << row.clock.time
                   << " s the dissipated energy has fallen by " << fall
                   << " J, which no material or wall does. Do not trust the "
                      "results; please report this with the parameter file."
                   << std::endl;
  }



  template <int dim>
  std::vector<WallTraction>
  Observers<dim>::observe_walls(const FlowView &view)
  {
    if (!parameters.writes_walls)
      return {};
    std::vector<WallTraction> tractions =
      wall_tractions.since_last(view.clock().time, view.wall_records());
    largest_pressure.add(tractions, summary.has_flow_rate);
    design.add_walls(tractions,
                     summary.totals.mass_in_silo / summary.initial_mass);
    return tractions;
  }



  template <int dim>
  void
  Observers<dim>::observe_fields(const FlowView           &view,
                                 std::vector<WallTraction> tractions)
  {
    field_times.pass(view.clock().time);
    last_field_step = view.clock().step;

    // Collecting is for all ranks together; writing is each rank's own, and the
    // run goes on meanwhile.
    std::vector<std::pair<FieldSeries *, VtuPiece>> pieces;
    if (parameters.writes_particles)
      pieces.emplace_back(&particles, particle_fields(view, layers));
    if (parameters.writes_grid)
      pieces.emplace_back(&grid, grid_fields(view, dim));
    finish_writing();
    const auto write_design = design.output(view.clock().time,
                                            summary.totals.mass_discharged(),
                                            tractions);

    writing.start([this,
                   write_design,
                   time      = view.clock().time,
                   pieces    = std::move(pieces),
                   tractions = std::move(tractions)]() {
      for (const auto &[series, piece] : pieces)
        series->write(time, piece);
      if (!tractions.empty())
        wall_tractions.write(time, tractions);
      write_design();
    });
  }



  template <int dim>
  void
  Observers<dim>::finish_writing()
  {
    do_and_share_errors(communicator, [this]() { writing.finish(); });
  }



  template <int dim>
  void
  Observers<dim>::write_summary(const std::string &status,
                                const std::string &message)
  {
    do_and_share_errors(communicator, [&]() {
      if (is_writer)
        write_summary_on_rank(status, message);
    });
  }



  template <int dim>
  void
  Observers<dim>::write_summary_on_rank(const std::string &status,
                                        const std::string &message)
  {
    summary.status  = status;
    summary.message = message;
    summary.seconds = {Timing::seconds(timings, Timing::set_up),
                       Timing::seconds(timings, Timing::static_stage),
                       Timing::seconds(timings, Timing::particle_loop),
                       Timing::seconds(timings, Timing::output)};
    if (summary.has_flow_rate)
      summary.flow = history.flow_summary();
    if (parameters.writes_walls)
      summary.largest_pressure = largest_pressure;
    design.summarise(summary);

    JsonObject json;
    json.add(summary_table, summary);
    write_summary_file(parameters.directory, json.text());
  }



#define INSTANTIATE(dim) template class Observers<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
