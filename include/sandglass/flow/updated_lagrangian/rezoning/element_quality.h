#ifndef sandglass_flow_updated_lagrangian_rezoning_element_quality_h
#define sandglass_flow_updated_lagrangian_rezoning_element_quality_h

#include <sandglass/flow/updated_lagrangian/rezoning/triangle_mesh.h>

namespace Sandglass
{
  /// Smallest Jacobian determinant of a cell over the largest absolute one, at
  /// its nodes and at the points of QGaussSimplex(1) to (3). 1 where edges are
  /// straight, 0 or less where the cell has turned over somewhere.
  double
  jacobian_ratio(const TriangleMesh &mesh, const unsigned int cell);

  /// Smallest angle in radians between the edges of a cell, at its corners,
  /// where edges may be curved; negative where the edges have crossed.
  double
  smallest_angle(const TriangleMesh &mesh, const unsigned int cell);
} // namespace Sandglass

#endif
