#ifndef sandglass_scene_triangulate_h
#define sandglass_scene_triangulate_h

#include <deal.II/grid/tria.h>

#include <sandglass/scene/mesh.h>

namespace Sandglass
{
  /**
   * Make a triangulation of `mesh`: active cell i is cell i of the mesh, and
   * boundary faces have the ids of the mesh's faces.
   *
   * Throws InputError if a boundary face is none of the mesh's, or a cell no
   * area.
   */
  template <int dim>
  void
  triangulate(const Mesh<dim> &mesh, dealii::Triangulation<dim> &triangulation);
} // namespace Sandglass

#endif
