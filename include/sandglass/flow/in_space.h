#ifndef sandglass_flow_in_space_h
#define sandglass_flow_in_space_h

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <sandglass/scene/cell_type.h>

/**
 * @file
 * How views show what a grid has, whatever its dimension.
 */

namespace Sandglass
{
  using namespace dealii;

  /// A vector of the grid among those of three components; the others are zero.
  template <typename Result, int dim>
  Result
  in_space(const Tensor<1, dim> &vector)
  {
    Result result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = vector[d];
    return result;
  }

  template <int dim>
  Point<3>
  in_space(const Point<dim> &point)
  {
    return in_space<Point<3>, dim>(point);
  }

  template <int dim>
  Tensor<1, 3>
  in_space(const Tensor<1, dim> &vector)
  {
    return in_space<Tensor<1, 3>, dim>(vector);
  }

  /// The vertex of a cell, in deal.II's numbers, that is VTK's n-th.
  template <int dim>
  unsigned int
  vertex_in_vtk_order(const CellType cell_type, const unsigned int n)
  {
    return is_simplex(cell_type) ? n : GeometryInfo<dim>::ucd_to_deal[n];
  }
} // namespace Sandglass

#endif
