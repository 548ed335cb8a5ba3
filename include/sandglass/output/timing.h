#ifndef sandglass_output_timing_h
#define sandglass_output_timing_h

#include <deal.II/base/timer.h>

#include <string>

namespace Sandglass
{
  using namespace dealii;

  /// Sections of the run's TimerOutput, in the order of the run.
  namespace Timing
  {
    inline const std::string set_up        = "Set-up";
    inline const std::string static_stage  = "Static stage";
    inline const std::string particle_loop = "Particle loop";
    inline const std::string output        = "Output";

    /// Wall time of a section so far, in s.
    inline double
    seconds(const TimerOutput &timings, const std::string &section)
    {
      const auto all   = timings.get_summary_data(TimerOutput::total_wall_time);
      const auto entry = all.find(section);
      return entry == all.end() ? 0. : entry->second;
    }
  } // namespace Timing
} // namespace Sandglass

#endif
