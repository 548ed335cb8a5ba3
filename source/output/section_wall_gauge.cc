#include <sandglass/flow/in_space.h>
#include <sandglass/output/section_wall_gauge.h>

#include <algorithm>

namespace Sandglass
{
  namespace
  {
    /// Of the distance of two nodes: a point nearer to the line between them is
    /// on the wall.
    constexpr double rounding = 1e-3;

    /// Where a point lies between two others, from 0 to 1; outside of that
    /// where it isn't between them.
    double
    place_between(const Point<3> &a, const Point<3> &b, const Point<3> &point)
    {
      const Tensor<1, 3> along  = b - a;
      const double       length = along.norm();
      const double       place  = along * (point - a) / (length * length);
      const double       distance =
        (point - a - std::clamp(place, 0., 1.) * along).norm();
      return distance <= rounding * length ? std::clamp(place, 0., 1.) : -1.;
    }
  } // namespace



  bool
  is_on_wall(const Scene<2> &scene, const Point<2> &point)
  {
    return std::any_of(
      scene.mesh.faces.begin(), scene.mesh.faces.end(), [&](const auto &edge) {
        return boundary_part(scene.walls, edge.boundary_id()).wall != no_wall &&
               place_between(in_space(scene.mesh.vertices[edge.vertices[0]]),
                             in_space(scene.mesh.vertices[edge.vertices[1]]),
                             in_space(point)) >= 0.;
      });
  }



  WallPressure
  traction_at(const Point<3> &point, const std::vector<WallTraction> &tractions)
  {
    for (unsigned int i = 1; i < tractions.size(); ++i)
      {
        const WallTraction &a = tractions[i - 1], &b = tractions[i];
        if (a.record.wall != b.record.wall || a.place.line != b.place.line ||
            a.record.vertex == b.record.vertex)
          continue;
        const double place =
          place_between(a.record.position, b.record.position, point);
        if (place >= 0.)
          return {(1. - place) * a.normal() + place * b.normal(),
                  (1. - place) * a.tangential() + place * b.tangential()};
      }
    return {};
  }
} // namespace Sandglass
