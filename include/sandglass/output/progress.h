#ifndef sandglass_output_progress_h
#define sandglass_output_progress_h

#include <sandglass/flow/clock.h>
#include <sandglass/output/log.h>
#include <sandglass/output/timing.h>

#include <chrono>

namespace Sandglass
{
  /**
   * Tells from time to time how far the run is. Rank 0 alone decides when, by
   * its clock, so that no step waits for other ranks.
   */
  class Progress
  {
  public:
    /**
     * @param interval  wall time between lines, in s; 0: no lines.
     * @param end_time  simulated time at which the run ends, in s.
     */
    Progress(Log               &log,
             const TimerOutput &timings,
             const double       interval,
             const double       end_time);

    /// The loop begins, at this simulated time.
    void
    start(const double time);

    /// Instead of start(): the loop goes on, reported by another object so far.
    void
    go_on_from(const Progress &before);

    /// @param n_particles  of all ranks, as far as known.
    void
    after_step(const Clock &clock, const unsigned long n_particles);

  private:
    using WallClock = std::chrono::steady_clock;

    void
    show(const Clock                &clock,
         const unsigned long         n_particles,
         const WallClock::time_point now);

    Log               &log;
    const TimerOutput &timings;
    const double       interval;
    const double       end_time;

    struct State
    {
      /// Simulated and wall time when the loop began.
      double                start_time = 0.;
      WallClock::time_point start_moment;

      /// Wall time, and the loop's seconds, at the last line.
      WallClock::time_point last_moment;
      double                last_loop_seconds = 0.;

      unsigned long particle_steps = 0; ///< since the last line
    };

    State state;
  };

  /// Likewise for the state at rest, whose end is a share of the weight.
  class RestProgress
  {
  public:
    /// @param interval  wall time between lines, in s; 0: no lines.
    RestProgress(Log &log, const double interval);

    /// @param load_share  of the whole weight, that has come to rest.
    void
    after_load_step(const double load_share);

  private:
    using WallClock = std::chrono::steady_clock;

    Log                        &log;
    const double                interval;
    const WallClock::time_point start_moment;
    WallClock::time_point       last_moment;
  };

  /// Hours, minutes and seconds as h:mm:ss.
  std::string
  duration_to_text(const double seconds);
} // namespace Sandglass

#endif
