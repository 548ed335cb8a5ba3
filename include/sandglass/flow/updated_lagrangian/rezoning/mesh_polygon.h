#ifndef sandglass_flow_updated_lagrangian_rezoning_mesh_polygon_h
#define sandglass_flow_updated_lagrangian_rezoning_mesh_polygon_h

#include <deal.II/base/point.h>

#include <sandglass/flow/updated_lagrangian/rezoning/size_field.h>

#include <array>
#include <vector>

namespace Sandglass
{
  /// Triangles with straight edges.
  struct Triangles
  {
    std::vector<Point<2>> corners; ///< in m
    /// Counter-clockwise.
    std::vector<std::array<unsigned int, 3>> cells;
  };

  /**
   * Mesh a polygon with holes by Gmsh, without new corners on its sides. The
   * loops' corners keep their places to the last digit; where loops touch in a
   * corner, the mesh has it once.
   *
   * @param loops  of the corners in m, counter-clockwise outside and clockwise
   *               round holes.
   *
   * Needs a GmshSession. The same input gives the same mesh. Throws RunError
   * where Gmsh fails.
   */
  Triangles
  mesh_polygon(const std::vector<std::vector<Point<2>>> &loops,
               const SizeField                          &size);
} // namespace Sandglass

#endif
