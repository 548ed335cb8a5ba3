#ifndef sandglass_flow_updated_lagrangian_rezoning_mesh_outlines_h
#define sandglass_flow_updated_lagrangian_rezoning_mesh_outlines_h

#include <sandglass/flow/updated_lagrangian/rezoning/outlines.h>
#include <sandglass/flow/updated_lagrangian/rezoning/size_field.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_mesh.h>

#include <vector>

namespace Sandglass
{
  /// Bodies meshed anew.
  struct NewMesh
  {
    TriangleMesh mesh;
    /// Of each body, the area in m^2 that the mesh has more than the outline.
    std::vector<double> area_gained;
    /// Boundary edges that have been made less curved than the outline, since
    /// their cells would have degenerated.
    unsigned int n_straightened = 0;
  };

  /**
   * Mesh bodies anew by Gmsh: body i of the mesh fills outline i, and its
   * boundary edges have the outline's marks. Edges inside are straight; those
   * at the boundary are curved as divide_loop() makes them, in order 2. The
   * same input gives the same mesh.
   *
   * In order 2 a body keeps its area to rounding, unless edges had to be
   * straightened; in order 1 to second order of the edges' length, where the
   * outline is curved.
   *
   * Throws RunError where Gmsh fails, mostly since an outline crosses itself.
   */
  NewMesh
  mesh_outlines(const std::vector<BodyOutline> &outlines,
                const SizeField                &size,
                const unsigned int              order);
} // namespace Sandglass

#endif
