#include <sandglass/output/progress.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace Sandglass
{
  namespace
  {
    template <typename Duration>
    double
    to_seconds(const Duration duration)
    {
      return std::chrono::duration<double>(duration).count();
    }
  } // namespace



  Progress::Progress(Log               &log,
                     const TimerOutput &timings,
                     const double       interval,
                     const double       end_time)
    : log(log)
    , timings(timings)
    , interval(interval)
    , end_time(end_time)
  {}



  void
  Progress::start(const double time)
  {
    state.start_time   = time;
    state.start_moment = state.last_moment = WallClock::now();
  }



  void
  Progress::go_on_from(const Progress &before)
  {
    state = before.state;
  }



  void
  Progress::after_step(const Clock &clock, const unsigned long n_particles)
  {
    if (interval == 0. || !log.stream().is_active())
      return;
    state.particle_steps += n_particles;
    const auto now = WallClock::now();
    if (to_seconds(now - state.last_moment) < interval)
      return;
    show(clock, n_particles, now);
    state.last_moment    = now;
    state.particle_steps = 0;
  }



  void
  Progress::show(const Clock                &clock,
                 const unsigned long         n_particles,
                 const WallClock::time_point now)
  {
    // The loop's time without that for output, as in the summary.
    const double loop_seconds = Timing::seconds(timings, Timing::particle_loop);
    const double rate =
      state.particle_steps / (loop_seconds - state.last_loop_seconds);
    state.last_loop_seconds = loop_seconds;

    const double remaining = to_seconds(now - state.start_moment) *
                             (end_time - clock.time) /
                             (clock.time - state.start_time);
    std::ostringstream line;
    line << "t = " << std::fixed << std::setprecision(4) << clock.time << " of "
         << std::defaultfloat << end_time << " s, step " << std::setprecision(3)
         << clock.time_step << " s, " << n_particles << " particles, "
         << rate / 1e6 << " million particle-steps/s, "
         << duration_to_text(remaining) << " left";
    log.show_progress(line.str());
  }



  RestProgress::RestProgress(Log &log, const double interval)
    : log(log)
    , interval(interval)
    , start_moment(WallClock::now())
    , last_moment(start_moment)
  {}



  void
  RestProgress::after_load_step(const double load_share)
  {
    const auto now = WallClock::now();
    if (interval == 0. || !log.stream().is_active() ||
        to_seconds(now - last_moment) < interval)
      return;
    last_moment = now;
    std::ostringstream line;
    line << "State at rest: " << std::setprecision(3) << 100. * load_share
         << " % of the weight, "
         << duration_to_text(to_seconds(now - start_moment) *
                             (1. - load_share) / load_share)
         << " left";
    log.show_progress(line.str());
  }



  std::string
  duration_to_text(const double seconds)
  {
    const unsigned long whole = std::lround(seconds);
    std::ostringstream  text;
    text << whole / 3600 << std::setfill('0') << ':' << std::setw(2)
         << whole / 60 % 60 << ':' << std::setw(2) << whole % 60;
    return text.str();
  }
} // namespace Sandglass
