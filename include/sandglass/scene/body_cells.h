#ifndef sandglass_scene_body_cells_h
#define sandglass_scene_body_cells_h

#include <sandglass/scene/mesh.h>

#include <array>
#include <vector>

namespace Sandglass
{
  /// The vertices of a cell's faces by their number in the cell: around each
  /// face, counterclockwise for who looks at the cell. What a tetrahedron's
  /// face lacks counts as its first vertex.
  using FacesOfCell = std::vector<std::array<unsigned int, 4>>;

  const FacesOfCell &
  faces_of_cell(const CellType cell_type);

  /// Order the vertices of each named face around it, outward from the filled
  /// cell at it, or from its only one.
  void
  order_faces(Mesh<3> &mesh);
} // namespace Sandglass

#endif
