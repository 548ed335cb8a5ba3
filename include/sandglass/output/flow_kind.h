#ifndef sandglass_output_flow_kind_h
#define sandglass_output_flow_kind_h

#include <sandglass/base/table.h>

#include <limits>
#include <string>
#include <vector>

namespace Sandglass
{
  /**
   * How fast material sinks beside a wall and in the middle at one height,
   * while the middle half of the discharged mass flowed.
   *
   * Their ratio is the mass flow index of Johanson and Jenike: below 0.3 the
   * material beside the wall stands as in funnel flow (ketterhagen2009).
   */
  struct FlowLevel
  {
    static constexpr double mass_flow_limit = 0.3;

    double      y;    ///< in m, middle of the band of heights
    double      top;  ///< its upper end, in m
    std::string side; ///< of the outlet: left or right
    double      wall_speed, middle_speed; ///< downwards, in m/s; NaN for none

    double
    mass_flow_index() const
    {
      return middle_speed > 0. ? wall_speed / middle_speed :
                                 std::numeric_limits<double>::quiet_NaN();
    }
  };

  /// Columns of flow_profile.csv.
  extern const std::vector<Column<FlowLevel>> flow_profile_table;

  /// Which of the flow patterns of EN 1991-4 (Section 1.5) a discharge has.
  struct FlowKind
  {
    /// Of levels on each side from below upwards; those without an index say
    /// nothing.
    explicit FlowKind(const std::vector<FlowLevel> &levels);
    FlowKind() = default;

    /// `mass flow`; `mixed flow` where the flow zone meets the wall below the
    /// surface, `pipe flow` where it doesn't: the two kinds of funnel flow.
    /// Empty where nothing flows.
    std::string name;

    /// Height above the outlet level up to which material stands beside a wall,
    /// in m; NaN in mass flow.
    double transition = std::numeric_limits<double>::quiet_NaN();

    /// On any level and side; NaN without any.
    double smallest_mass_flow_index = std::numeric_limits<double>::quiet_NaN();
  };
} // namespace Sandglass

#endif
