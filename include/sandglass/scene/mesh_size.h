#ifndef sandglass_scene_mesh_size_h
#define sandglass_scene_mesh_size_h

#include <vector>

namespace Sandglass
{
  /// By what share of the distance from the outlet's lip edges become longer.
  /// Neighbouring edges differ by a fifth, so cells stay good.
  constexpr double mesh_size_growth = 0.2;

  /**
   * Tell Gmsh's current model how long edges are to be: `size_at_points` in m
   * at these points, and from there on longer by mesh_size_growth of the
   * distance, up to `largest_size` in m.
   *
   * @param points  tags of points of the synchronized geometry.
   */
  void
  grade_mesh_size(const std::vector<int> &points,
                  const double            size_at_points,
                  const double            largest_size);
} // namespace Sandglass

#endif
