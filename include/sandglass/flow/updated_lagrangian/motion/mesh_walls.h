#ifndef sandglass_flow_updated_lagrangian_motion_mesh_walls_h
#define sandglass_flow_updated_lagrangian_motion_mesh_walls_h

#include <sandglass/flow/updated_lagrangian/motion/motion_setting.h>
#include <sandglass/flow/updated_lagrangian/rezoning/boundary_piece.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_mesh.h>

namespace Sandglass
{
  /// Over the length of an element: an edge so near to a wall lies on it.
  inline constexpr double distance_on_wall = 1e-3;

  /// The same where an edge has been divided at a wall's end; and how near to
  /// such an end the boundary runs through it.
  inline constexpr double distance_at_wall_end = 0.1;

  /// Index of the wall on which a curve of the boundary lies, with the material
  /// on its left, or TriangleMesh::free_surface.
  unsigned int
  wall_of(const QuadraticCurve &curve, const MotionSetting &setting);

  /// Mark the boundary edges that lie on walls with the walls' indices.
  void
  mark_walls(TriangleMesh &mesh, const MotionSetting &setting);

  /// Put the nodes of a mesh's wall edges on the walls' lines, and those near
  /// walls' free ends there; nodes on edges go half the way with their ends.
  void
  snap_to_walls(TriangleMesh &mesh, const MotionSetting &setting);
} // namespace Sandglass

#endif
