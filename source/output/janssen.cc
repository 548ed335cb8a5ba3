#include <deal.II/base/numbers.h>

#include <sandglass/output/janssen.h>

#include <cmath>

namespace Sandglass
{
  double
  Janssen::standard_lateral_pressure_ratio(const double internal_friction_angle)
  {
    return 1.1 * (1. - std::sin(internal_friction_angle * dealii::numbers::PI /
                                180.));
  }



  double
  Janssen::horizontal_pressure(const double depth) const
  {
    const double without_friction =
      weight_density * lateral_pressure_ratio * depth;
    const double relative_depth =
      lateral_pressure_ratio * friction_coefficient * depth / hydraulic_radius;
    if (relative_depth == 0.)
      return without_friction;
    return without_friction * -std::expm1(-relative_depth) / relative_depth;
  }
} // namespace Sandglass
