#ifndef sandglass_flow_updated_lagrangian_rezoning_triangle_element_h
#define sandglass_flow_updated_lagrangian_rezoning_triangle_element_h

#include <deal.II/base/quadrature.h>
#include <deal.II/base/tensor.h>

#include <sandglass/flow/updated_lagrangian/rezoning/field.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_mesh.h>

#include <array>
#include <functional>
#include <vector>

namespace Sandglass
{
  /// The nodes' places in the reference triangle (0,0), (1,0), (0,1).
  extern const std::array<Point<2>, 6> reference_nodes;

  /// Values of the nodes' Lagrange polynomials of an order at a point of the
  /// reference triangle, or outside of it.
  std::array<double, 6>
  shape_values(const unsigned int order, const Point<2> &reference_point);

  /// Their gradients by reference coordinates.
  std::array<Tensor<1, 2>, 6>
  shape_gradients(const unsigned int order, const Point<2> &reference_point);

  /// Where a cell's reference point lies, in m.
  Point<2>
  position_in_cell(const TriangleMesh &mesh,
                   const unsigned int  cell,
                   const Point<2>     &reference_point);

  /// The same of the reference triangle's centre.
  Point<2>
  middle_of_cell(const TriangleMesh &mesh, const unsigned int cell);

  /// All components of a nodal field at a cell's reference point.
  void
  evaluate_in_cell(const TriangleMesh &mesh,
                   const MeshField    &field,
                   const unsigned int  cell,
                   const Point<2>     &reference_point,
                   double             *values);

  /// J_ij = dx_i / dxi_j there, in m.
  Tensor<2, 2>
  jacobian_in_cell(const TriangleMesh &mesh,
                   const unsigned int  cell,
                   const Point<2>     &reference_point);

  /// Depth of the material at a point of the section: 1 in plane strain, per m,
  /// and 2 pi x round the axis x = 0, in m.
  using Depth = std::function<double(const Point<2> &)>;

  /// Where the quadrature points lie, cell by cell, in m.
  std::vector<Point<2>>
  quadrature_positions(const TriangleMesh  &mesh,
                       const Quadrature<2> &quadrature);

  /// The volumes that the quadrature points stand for, cell by cell, in m^3
  /// (plane strain: per m). They are negative in a cell that has turned over.
  std::vector<double>
  quadrature_volumes(const TriangleMesh  &mesh,
                     const Quadrature<2> &quadrature,
                     const Depth         &depth);

  /// Area of each cell in m^2, exact also where edges are curved.
  std::vector<double>
  cell_areas(const TriangleMesh &mesh);
} // namespace Sandglass

#endif
