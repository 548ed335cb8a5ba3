#ifndef sandglass_scene_outline_h
#define sandglass_scene_outline_h

#include <deal.II/base/point.h>

namespace Sandglass
{
  /**
   * The outline of a silo or an outlet seen from above: a circle, or a
   * rectangle whose sides are along x and z. Points of the plan are (x, z);
   * lengths in m.
   *
   * Plans are meshed as images of the square with |s|, |t| <= 1: its side s = 1
   * is the outline's side towards +x, the side t = 1 that towards +z. Of a
   * circle, a side is a quarter.
   */
  struct Outline
  {
    bool             is_round;
    double           half_width; ///< along x; of a circle, the radius
    double           half_depth; ///< along z; of a circle, the radius
    dealii::Point<2> middle;

    /// Where a point of the square lies: on its border on the outline, inside
    /// on the straight line from the middle to the outline.
    dealii::Point<2>
    at(const dealii::Point<2> &of_square) const;

    /// Distance of a point of the plan from the outline, in m.
    double
    distance(const dealii::Point<2> &point) const;

    /// In m^2.
    double
    area() const;

    /// Length of the outline, in m.
    double
    perimeter() const;
  };
} // namespace Sandglass

#endif
