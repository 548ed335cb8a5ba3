#ifndef sandglass_scene_mesh_size_h
#define sandglass_scene_mesh_size_h

#include <vector>

namespace Sandglass
{
  /**
   * Tell Gmsh's current model how long edges are to be: `size_at_points` in m
   * at these points, and from there on longer by a share of the distance, up
   * to `largest_size` in m.
   *
   * @param points  tags of points of the synchronized geometry.
   */
  void
  grade_mesh_size(const std::vector<int> &points,
                  const double            size_at_points,
                  const double            largest_size);
} // namespace Sandglass

#endif
