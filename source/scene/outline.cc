#include <deal.II/base/numbers.h>

#include <sandglass/scene/outline.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  using dealii::Point;

  Point<2>
  Outline::at(const Point<2> &of_square) const
  {
    const double s = of_square[0], t = of_square[1];
    if (!is_round)
      return Point<2>(middle[0] + s * half_width, middle[1] + t * half_depth);
    const double outwards = std::max(std::abs(s), std::abs(t));
    if (outwards == 0.)
      return middle;
    // Equal steps along a side of the square are equal angles.
    constexpr double eighth     = dealii::numbers::PI_4;
    const bool       is_along_x = std::abs(s) >= std::abs(t);
    const double     angle      = eighth * (is_along_x ? t / s : s / t);
    const double     radius     = half_width * (is_along_x ? s : t);
    return middle +
           Point<2>(radius * (is_along_x ? std::cos(angle) : std::sin(angle)),
                    radius * (is_along_x ? std::sin(angle) : std::cos(angle)));
  }



  double
  Outline::distance(const Point<2> &point) const
  {
    if (is_round)
      return std::abs(point.distance(middle) - half_width);
    const double x = std::abs(point[0] - middle[0]) - half_width;
    const double z = std::abs(point[1] - middle[1]) - half_depth;
    return x < 0. && z < 0. ? -std::max(x, z) :
                              std::hypot(std::max(x, 0.), std::max(z, 0.));
  }



  double
  Outline::area() const
  {
    return is_round ? dealii::numbers::PI * half_width * half_width :
                      4. * half_width * half_depth;
  }



  double
  Outline::perimeter() const
  {
    return is_round ? 2. * dealii::numbers::PI * half_width :
                      4. * (half_width + half_depth);
  }
} // namespace Sandglass
