#ifndef sandglass_flow_clock_h
#define sandglass_flow_clock_h

#include <sstream>
#include <string>

namespace Sandglass
{
  /// Time of a flow; what a restart continues from.
  struct Clock
  {
    double        time      = 0.; ///< in s
    double        time_step = 0.; ///< the last one taken, in s
    unsigned long step      = 0;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &time &time_step &step;
    }
  };

  /// The beginning of an error message: step, time and time step.
  inline std::string
  describe(const Clock &clock)
  {
    std::ostringstream text;
    text << "Step " << clock.step << ", t = " << clock.time << " s, time step "
         << clock.time_step << " s: ";
    return text.str();
  }
} // namespace Sandglass

#endif
