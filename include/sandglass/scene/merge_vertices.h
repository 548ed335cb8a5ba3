#ifndef sandglass_scene_merge_vertices_h
#define sandglass_scene_merge_vertices_h

#include <sandglass/scene/gmsh_mesh.h>
#include <sandglass/scene/mesh.h>

namespace Sandglass
{
  /**
   * Join surfaces that meet without sharing their nodes: where two of the
   * cells' faces lie at the same place, and no wall or axis is there to part
   * them, the second one's vertices are replaced by the first one's. Returns
   * how many vertices this takes away.
   *
   * Faces that Gmsh has given nodes of their own are put on the cells' vertices
   * as well.
   */
  template <int dim>
  unsigned int
  merge_vertices(Mesh<dim> &mesh, GmshMesh &gmsh_mesh);
} // namespace Sandglass

#endif
