#ifndef sandglass_output_section_outline_h
#define sandglass_output_section_outline_h

#include <sandglass/output/small_sine.h>
#include <sandglass/walls/wall.h>

#include <algorithm>
#include <limits>
#include <optional>

/**
 * @file
 * What is asked of a section's outline to find its vertical part.
 */

namespace Sandglass
{
  /// Lowest and highest of some numbers; empty without any.
  struct Range
  {
    double lower = std::numeric_limits<double>::infinity(),
           upper = -std::numeric_limits<double>::infinity();

    void
    add(const double x)
    {
      lower = std::min(lower, x);
      upper = std::max(upper, x);
    }

    double
    length() const
    {
      return std::max(0., upper - lower);
    }

    double
    middle() const
    {
      return (lower + upper) / 2.;
    }
  };

  /// The friction that walls have in common; none where they differ or move.
  class CommonFriction
  {
  public:
    void
    add(const Wall<2> &wall)
    {
      const bool fits =
        wall.velocity.norm() == 0. &&
        (!coefficient || *coefficient == wall.friction_coefficient);
      is_common   = is_common && fits;
      coefficient = wall.friction_coefficient;
    }

    std::optional<double>
    value() const
    {
      return is_common ? coefficient : std::nullopt;
    }

  private:
    std::optional<double> coefficient;
    bool                  is_common = true;
  };
} // namespace Sandglass

#endif
