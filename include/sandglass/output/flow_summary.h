#ifndef sandglass_output_flow_summary_h
#define sandglass_output_flow_summary_h

#include <limits>
#include <optional>

namespace Sandglass
{
  /// A stretch of time over which the flow rate hardly changes; NaN for none.
  struct SteadyFlow
  {
    double start = std::numeric_limits<double>::quiet_NaN(); ///< in s
    double end   = std::numeric_limits<double>::quiet_NaN(); ///< in s
    double rate  = std::numeric_limits<double>::quiet_NaN(); ///< mean, in kg/s
  };

  /// What a discharge was like as a whole, for summary.json. NaN where it
  /// can't be told.
  struct FlowSummary
  {
    /// Mean rate over the middle half of the discharged mass, in kg/s.
    double plateau = std::numeric_limits<double>::quiet_NaN();

    SteadyFlow steady;

    /// The time of FlowRate::discharge_time(), in s.
    double discharge_time = std::numeric_limits<double>::quiet_NaN();

    /// Share of the walls that slips, mean over the plateau; see FlowPattern.
    double slipping_wall_share = std::numeric_limits<double>::quiet_NaN();

    /// The latest stagnant mass, in kg; see FlowPattern. No value if it was not
    /// asked for.
    std::optional<double> stagnant_mass;
  };
} // namespace Sandglass

#endif
