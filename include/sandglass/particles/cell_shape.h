#ifndef sandglass_particles_cell_shape_h
#define sandglass_particles_cell_shape_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <sandglass/base/lanes.h>
#include <sandglass/scene/cell_type.h>

#include <array>

namespace Sandglass
{
  using namespace dealii;

  /**
   * Geometry and linear shape functions of one cell, in the numbering of
   * deal.II's reference cells. Specialised for each cell type with the same
   * members (`dim` among them), of which the first four also take the points of
   * Lanes of particles:
   *
   * - shape_values(reference_point): N_i, one per node;
   * - shape_gradients(reference_point): dN_i/dx in 1/m;
   * - to_reference(point): reference coordinates of a point in or near the
   *   cell;
   * - to_reference(point, start): the same, from coordinates near them;
   * - to_real(reference_point): its position in m;
   * - node(i): position of node i in m;
   * - jacobian(reference_point): area per reference area, in m^2 (in space:
   *   volume per reference volume, in m^3);
   * - face_distances(reference_point): for each face a number that is negative
   *   beyond it and grows inwards, 0 on it, of the order of 1 across the cell;
   * - walk_distances(point): the same for any point, also where a
   *   quadrilateral's or hexahedron's reference coordinates don't exist.
   */
  template <CellType cell_type>
  class CellShape;

  /// The numbers of a vector or point.
  template <int dim>
  std::array<double, dim>
  components_of(const Tensor<1, dim> &tensor)
  {
    std::array<double, dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = tensor[d];
    return result;
  }

  template <std::size_t dim>
  Point<static_cast<int>(dim)>
  point_of(const std::array<double, dim> &coordinates)
  {
    Point<static_cast<int>(dim)> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = coordinates[d];
    return result;
  }
} // namespace Sandglass

#include <sandglass/particles/hexahedron_shape.h>
#include <sandglass/particles/quadrilateral_shape.h>
#include <sandglass/particles/tetrahedron_shape.h>
#include <sandglass/particles/triangle_shape.h>

#endif
