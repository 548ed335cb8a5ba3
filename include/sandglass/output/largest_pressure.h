#ifndef sandglass_output_largest_pressure_h
#define sandglass_output_largest_pressure_h

#include <sandglass/output/section_wall_tractions.h>

#include <boost/serialization/string.hpp>

#include <string>
#include <vector>

namespace Sandglass
{
  /// The largest of all normal tractions of wall_traction.csv so far, and where
  /// it was. On rank 0.
  class LargestPressure
  {
  public:
    /// Consider those of one time. The outlet counts as long as it is a wall:
    /// not at rest, where it opens then.
    void
    add(const std::vector<WallTraction> &tractions, const bool outlet_opens);

    /// Whether there has been any pressure.
    bool
    is_known() const
    {
      return pressure > 0.;
    }

    double      pressure = 0.;  ///< in Pa
    double      time     = 0.;  ///< in s, when the mean over time ends
    double      x = 0., y = 0.; ///< of the node, in m
    std::string wall;           ///< its name
    /// By EN 1991-4 at discharge, and Janssen's, there, in Pa; NaN where they
    /// don't apply.
    double eurocode = 0., janssen = 0.;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &pressure &time &x &y &wall &eurocode &janssen;
    }
  };
} // namespace Sandglass

#endif
