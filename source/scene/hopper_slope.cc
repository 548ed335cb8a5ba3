#include <sandglass/scene/hopper_slope.h>

#include <cmath>

namespace Sandglass
{
  bool
  hopper_is_steep(const SceneParameters &parameters)
  {
    const double height = parameters.hopper_height;
    const double overhang =
      parameters.half_width - parameters.outlet_half_width;
    const auto angle = [&](const double width) {
      return std::atan2(height, width);
    };
    const double eccentricity = parameters.outlet_eccentricity;
    return height > 0. &&
           angle(overhang - eccentricity) + angle(overhang + eccentricity) >=
             std::acos(0.);
  }
} // namespace Sandglass
