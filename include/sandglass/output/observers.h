#ifndef sandglass_output_observers_h
#define sandglass_output_observers_h

#include <sandglass/flow/flow_view.h>
#include <sandglass/flow/updated_lagrangian/static_state.h>
#include <sandglass/output/background_task.h>
#include <sandglass/output/body_wall_tractions.h>
#include <sandglass/output/design_results.h>
#include <sandglass/output/history.h>
#include <sandglass/output/particle_fields.h>
#include <sandglass/output/progress.h>
#include <sandglass/output/schedule.h>
#include <sandglass/output/section_wall_tractions.h>
#include <sandglass/output/summary.h>
#include <sandglass/output/timing.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /// What output shows of the state at rest.
  struct AtRest
  {
    WallRecords  wall_records;
    StaticEffort effort;
  };

  /**
   * All that watches a run and writes what it sees into the output directory,
   * which the run has, see OutputDirectory. What a scene or the parameters
   * don't ask for is neither computed nor mentioned.
   *
   * Fields and walls are written beside the run, and are complete when the next
   * ones are due or the run stops; other files are complete after each call.
   * Throws RunError where a file can't be written.
   */
  template <int dim>
  class Observers
  {
  public:
    /// @param resolution  that the scene was made with.
    /// @param end_time    of the flow, in s.
    /// @param is_fed      whether something may enter.
    /// @param timings     has the sections of Timing; these times are reported.
    Observers(const OutputParameters   &parameters,
              const Scene<dim>         &scene,
              const Resolution         &resolution,
              const MaterialParameters &material,
              const double              end_time,
              const bool                is_fed,
              Log                      &log,
              TimerOutput              &timings);

    /// The run begins: from now on summary.json says so. Collective.
    void
    begin(const FlowView &view);

    /**
     * Write the state at t = 0. Collective.
     *
     * @param at_rest  the state at rest, or a null pointer if it was not
     *                 computed.
     */
    void
    start(const FlowView &view, const AtRest *at_rest);

    /**
     * Throws InputError unless the tables in a directory, where the run that
     * archived() has written them, are there and have these columns. Nothing is
     * written. Collective.
     */
    void
    refuse_other_tables(const std::string &archived,
                        const std::string &directory);

    /// Instead of begin() and start(): go on behind what observers had written
    /// when archived() was called, in another process. Collective.
    void
    go_on_from(const std::string &archived, const FlowView &view);

    /**
     * Instead of start(): go on behind what another partition's observers have
     * written. Collective.
     *
     * @param view_before  of the other partition's flow, at the same time.
     */
    void
    go_on_from(Observers      &before,
               const FlowView &view_before,
               const FlowView &view);

    /// Write what is due. Ranks wait for each other only if something is.
    void
    after_step(const FlowView &view);

    /// Write the last state, unless it has been written. Collective.
    void
    observe_end(const FlowView &view);

    /// Means of tractions on walls begin now: walls have come or gone.
    void
    start_wall_means_anew()
    {
      wall_tractions.start_means_anew();
    }

    /// Write the summary, the timing table and what has come out. Collective.
    /// @param event  that has ended the run; empty at its end time.
    void
    finish(const std::string &event = "");

    /// Write the summary of a run that ends before its time, but can go on.
    /// Collective.
    void
    stop(const FlowView &view, const std::string &message);

    /// Write the summary of a run that failed. Not collective: the first rank
    /// writes, and any other only what it knows, that it has failed.
    void
    finish_after_failure(const std::string &message);

    /// What summary.json says; on rank 0 with the flow's rates.
    const Summary &
    what_happened() const
    {
      return summary;
    }

    /// The step of the last row of history.csv.
    unsigned long
    last_row_step() const
    {
      return last_history_step;
    }

    /// The discharged mass over time; on rank 0.
    const FlowRate &
    discharge() const
    {
      return history.discharge();
    }

    /// All that go_on_from() needs; waits for the files that are being
    /// written. Collective.
    std::string
    archived();

    /// What go_on_from() needs to know.
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &last_history_step &last_field_step;
      archive &summary.n_particles &summary.initial_mass;
      archive &history &particles &grid &wall_tractions &largest_pressure
        &design;
    }

  private:
    /// What archived() has returned.
    void
    load(const std::string &archived);
    /// All but the progress. Collective.
    void
    restore(const std::string &archived, const FlowView &view);
    /// Wait for the files that are being written. Collective.
    void
    finish_writing();
    /// Open all tables and time series. Collective.
    void
    open_files();
    /// Of the whole silo and the whole process. Collective.
    SiloTotals
    totals(const FlowView &view) const;
    /// Collective.
    void
    update_summary(const Clock &clock, const SiloTotals &totals);
    /// @param is_exact  find the critical step for these very positions.
    /// @param tractions  since the last row, where the design results need
    /// them.
    void
    observe_history(const FlowView                  &view,
                    const bool                       is_exact,
                    const std::vector<WallTraction> &tractions);
    /// Likewise, with those since the last row.
    void
    observe_history(const FlowView &view, const bool is_exact);
    /// Say so if dissipated energy has come back since the last row.
    void
    check_dissipation(const SiloTotals &before, const HistoryRow &row);
    /// @param tractions  to be written too; empty: none.
    void
    observe_fields(const FlowView &view, std::vector<WallTraction> tractions);
    /// Since the last output; empty if nobody asks.
    std::vector<WallTraction>
    observe_walls(const FlowView &view);
    /// Collective.
    void
    write_summary(const std::string &status, const std::string &message = "");
    /// Write the file; on one rank.
    void
    write_summary_on_rank(const std::string &status,
                          const std::string &message);

    const OutputParameters &parameters;
    const MPI_Comm          communicator;
    const double            symmetry_factor;
    const Layers            layers;
    const bool              is_writer;
    Log                    &log;
    TimerOutput            &timings;

    Schedule history_times, field_times;
    /// Step of the last output, so that the end is not written twice.
    unsigned long last_history_step = 0, last_field_step = 0;
    /// Of this process' flows on other partitions.
    unsigned long particle_steps_before = 0;

    Summary            summary;
    Progress           progress;
    History            history;
    FieldSeries        particles, grid;
    WallTractions<dim> wall_tractions;
    LargestPressure    largest_pressure;
    DesignResults<dim> design;

    /// Writes particles, grid, walls and design results, so it is destroyed
    /// first.
    BackgroundTask writing;
  };
} // namespace Sandglass

#endif
