#ifndef sandglass_output_observers_h
#define sandglass_output_observers_h

#include <sandglass/output/background_task.h>
#include <sandglass/output/checkpoint.h>
#include <sandglass/output/history.h>
#include <sandglass/output/progress.h>
#include <sandglass/output/schedule.h>
#include <sandglass/output/summary.h>
#include <sandglass/output/timing.h>
#include <sandglass/output/wall_tractions.h>
#include <sandglass/flow/updated_lagrangian/static_state.h>

namespace Sandglass
{
  /**
   * All that watches a run and writes what it sees into the output directory,
   * which prepare_output_directory() has made. What a scene or the parameters
   * don't ask for is neither computed nor mentioned.
   *
   * Fields and walls are written beside the run; all other files are complete
   * after each call, and those when the next ones are due, or the run stops.
   */
  class Observers
  {
  public:
    /// @param timings  has the sections of Timing; these times are reported.
    Observers(const OutputParameters   &parameters,
              const Scene              &scene,
              const MaterialParameters &material,
              const WallParameters     &walls,
              const double              end_time,
              Log                      &log,
              TimerOutput              &timings);

    /**
     * Write the state at t = 0. Collective.
     *
     * @param static_state  the state at rest, or a null pointer if it was not
     *                      computed.
     */
    void
    start(ParticleStage &stage, const StaticState *static_state);

    /**
     * Instead of start(): put the stage into the state of a checkpoint, and go
     * on behind what had been written until then. Collective.
     */
    void
    resume(ParticleStage &stage, const Checkpoint &checkpoint);

    /// Instead of start(): go on behind what another partition's observers have
    /// written. Collective.
    void
    go_on_from(Observers &before, ParticleStage &stage);

    /// Write what is due. Ranks wait for each other only if something is.
    void
    after_step(ParticleStage &stage);

    /// Write the last state, the summary and the timing table. Collective.
    void
    finish(ParticleStage &stage);

    /// Write the summary of a run that failed. Not collective.
    void
    finish_after_failure(const std::string &message);

    /// What resume() needs to know.
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &last_history_step &last_field_step;
      archive &summary.n_particles      &summary.initial_mass;
      archive &history &particles &grid &wall_tractions;
    }

  private:
    /// Go on behind what the archived observers have written. Collective.
    void
    go_on_from(const std::string &archived, ParticleStage &stage);
    /// All that another object needs to go on. After finish_writing().
    std::string
    archived() const;
    /// Wait for the files that are being written. Collective.
    void
    finish_writing();
    /// Open all tables and time series. Collective.
    void
    open_files();
    /// Collective.
    void
    update_summary(const Clock &clock, const ParticleTotals &totals);
    /// @param is_exact  find the critical step for these very positions.
    void
    observe_history(ParticleStage &stage, const bool is_exact);
    /// Write fields, and the walls' tractions unless there are none.
    void
    observe_fields(ParticleStage                &stage,
                   const std::vector<WallForce> *wall_forces);
    void
    observe_checkpoint(ParticleStage &stage);
    void
    write_summary(const std::string &status) const;
    /// Write the file; on one rank.
    void
    write_summary_file(const std::string &status,
                       const std::string &message) const;

    const OutputParameters   &parameters;
    const Scene              &scene;
    const MaterialParameters &material;
    const WallParameters     &walls;
    const MPI_Comm            communicator;
    const bool                is_writer;
    Log                      &log;
    TimerOutput              &timings;

    Schedule history_times, field_times, checkpoint_times;
    /// Step of the last output, so that the end is not written twice.
    unsigned long last_history_step = 0, last_field_step = 0;

    Summary       summary;
    Progress      progress;
    History       history;
    FieldSeries   particles, grid;
    WallTractions wall_tractions;

    /// Of particles, grid and wall_tractions, and so the first to go.
    BackgroundTask writing;
  };
} // namespace Sandglass

#endif
