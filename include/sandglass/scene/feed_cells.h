#ifndef sandglass_scene_feed_cells_h
#define sandglass_scene_feed_cells_h

#include <sandglass/continuum/formulation.h>
#include <sandglass/scene/mesh.h>

#include <vector>

namespace Sandglass
{
  /// The filled cells that touch the material's surface, in order.
  template <int dim>
  std::vector<unsigned int>
  surface_cells(const Mesh<dim> &mesh);

  /// The cells at the mesh's top, in order.
  template <int dim>
  std::vector<unsigned int>
  top_cells(const Mesh<dim> &mesh);

  /// Mean of a cell's vertices, in m.
  template <int dim>
  dealii::Point<dim>
  middle_of_cell(const Mesh<dim> &mesh, const unsigned int cell);

  /// Area of the top's faces at some cells as seen from above, in m^2 (plane
  /// strain: per metre of depth).
  template <int dim>
  double
  opening_area(const Mesh<dim>                 &mesh,
               const std::vector<unsigned int> &cells,
               const Formulation                formulation);
} // namespace Sandglass

#endif
