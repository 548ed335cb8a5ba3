// What lies below the vertical part: the hopper and the outlet.

#include <sandglass/output/section_outline.h>
#include <sandglass/output/section_vertical_part.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  void
  VerticalPart::find_hopper(const Scene<2>          &scene,
                            const std::vector<Edge> &edges)
  {
    CommonFriction friction;
    double         slope    = std::numeric_limits<double>::quiet_NaN();
    bool           fits     = true;
    bool           has_step = false;
    for (const Edge &edge : edges)
      {
        if (edge.upper[1] > foot + rounding || is_part_of_side(edge))
          continue;
        const Tensor<1, 2> along = edge.upper - edge.lower;
        if (along[1] <= small_sine * along.norm())
          {
            // A floor below the hopper is none of it, one within it a step.
            has_step = has_step || edge.upper[1] >= bottom + rounding;
            continue;
          }
        friction.add(scene.walls[edge.wall]);
        const double of_edge = along[0] / along[1]; // > 0 at the right
        if (std::isnan(slope))
          slope = std::abs(of_edge);
        const double side = of_edge > 0. ?
                              *std::max_element(sides.begin(), sides.end()) :
                              *std::min_element(sides.begin(), sides.end());
        for (const Point<2> &end : {edge.lower, edge.upper})
          fits = fits && std::abs(end[0] - side +
                                  std::copysign(slope, of_edge) *
                                    (foot - end[1])) <= 2. * rounding;
      }
    is_plain = is_plain && !has_step;
    if (std::isnan(slope) || !fits || has_step || !friction.value())
      return;
    hopper_slope                = slope;
    hopper_friction_coefficient = friction.value();
  }



  void
  VerticalPart::find_outlet(const Scene<2> &scene)
  {
    Range  outlet, walls;
    double length = 0.;
    for (const auto &edge : scene.mesh.faces)
      if (edge.role == BoundaryRole::outlet)
        {
          const Point<2> &a = scene.mesh.vertices[edge.vertices[0]];
          const Point<2> &b = scene.mesh.vertices[edge.vertices[1]];
          length += a.distance(b);
          for (const Point<2> &point : {a, b})
            outlet.add(point[0]);
        }
    if (length == 0.)
      return;
    for (const double side : sides)
      walls.add(side);
    const bool is_one =
      std::abs(length - outlet.length()) <= rounding &&
      (sides.size() == 2 || std::abs(outlet.lower - *axis) <= rounding ||
       std::abs(outlet.upper - *axis) <= rounding);
    outlet_eccentricity = !is_one ? std::numeric_limits<double>::infinity() :
                          sides.size() == 2 ?
                                    std::abs(outlet.middle() - walls.middle()) :
                                    0.;
  }
} // namespace Sandglass
