#ifndef sandglass_scene_hanging_vertex_h
#define sandglass_scene_hanging_vertex_h

#include <sandglass/scene/mesh_faces.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /**
   * What a message about nameless faces adds where a vertex of one lies on
   * another, between its ends; empty if none does. A hanging node splits one
   * cell's edge only: the first such face is moved to the front. Faces in three
   * dimensions are not looked at.
   */
  template <int dim>
  std::string
  hanging_vertex(const Mesh<dim> &mesh, std::vector<FaceKey<dim>> &faces);
} // namespace Sandglass

#endif
