#ifndef sandglass_output_schedule_h
#define sandglass_output_schedule_h

#include <cmath>
#include <limits>

namespace Sandglass
{
  /**
   * When something that happens in equal intervals of time is due: at the first
   * step that reaches a multiple of the interval. The steps are not cut to hit
   * it, so that results don't depend on what is written.
   */
  class Schedule
  {
  public:
    /// @param interval  in s; 0: never due.
    explicit Schedule(const double interval)
      : interval(interval)
      , next_time(interval > 0. ? interval :
                                  std::numeric_limits<double>::infinity())
    {}

    bool
    is_due(const double time) const
    {
      return time >= next_time * (1. - rounding);
    }

    /// All times up to `time` are done with.
    void
    pass(const double time)
    {
      if (interval > 0.)
        next_time =
          interval * (std::floor(time / interval * (1. + rounding)) + 1.);
    }

  private:
    /// Relative error of a time that is the sum of many steps.
    static constexpr double rounding = 1e-9;

    const double interval;
    double       next_time;
  };
} // namespace Sandglass

#endif
