#ifndef sandglass_scene_triangulate_h
#define sandglass_scene_triangulate_h

#include <deal.II/grid/tria.h>

#include <sandglass/scene/mesh.h>

namespace Sandglass
{
  /**
   * Make a triangulation of `mesh`: active cell i is cell i of the mesh, and
   * boundary ids are BoundaryRole values.
   *
   * Throws InputError if a boundary edge of the mesh has no role, or a cell no
   * area.
   */
  template <int dim>
  void
  triangulate(const Mesh<dim> &mesh, dealii::Triangulation<dim> &triangulation);
} // namespace Sandglass

#endif
