#include <sandglass/flow/updated_lagrangian/rezoning/boundary_piece.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_element.h>

#include <algorithm>

namespace Sandglass
{
  namespace
  {
    /// Barycentric coordinates and their gradients.
    std::array<double, 3>
    barycentric(const Point<2> &p)
    {
      return {{1. - p[0] - p[1], p[0], p[1]}};
    }

    const std::array<Tensor<1, 2>, 3> barycentric_gradients = {
      {Tensor<1, 2>({-1., -1.}),
       Tensor<1, 2>({1., 0.}),
       Tensor<1, 2>({0., 1.})}};
  } // namespace



  const std::array<Point<2>, 6> reference_nodes = {{Point<2>(0., 0.),
                                                    Point<2>(1., 0.),
                                                    Point<2>(0., 1.),
                                                    Point<2>(0.5, 0.),
                                                    Point<2>(0.5, 0.5),
                                                    Point<2>(0., 0.5)}};



  std::array<double, 6>
  shape_values(const unsigned int order, const Point<2> &reference_point)
  {
    const auto            l = barycentric(reference_point);
    std::array<double, 6> values{};
    for (unsigned int v = 0; v < 3; ++v)
      if (order == 1)
        values[v] = l[v];
      else
        {
          values[v]     = l[v] * (2. * l[v] - 1.);
          values[3 + v] = 4. * l[v] * l[(v + 1) % 3];
        }
    return values;
  }



  std::array<Tensor<1, 2>, 6>
  shape_gradients(const unsigned int order, const Point<2> &reference_point)
  {
    const auto                  l = barycentric(reference_point);
    const auto                 &g = barycentric_gradients;
    std::array<Tensor<1, 2>, 6> gradients;
    for (unsigned int v = 0; v < 3; ++v)
      if (order == 1)
        gradients[v] = g[v];
      else
        {
          const unsigned int w = (v + 1) % 3;
          gradients[v]         = (4. * l[v] - 1.) * g[v];
          gradients[3 + v]     = 4. * (l[v] * g[w] + l[w] * g[v]);
        }
    return gradients;
  }



  Point<2>
  position_in_cell(const TriangleMesh &mesh,
                   const unsigned int  cell,
                   const Point<2>     &reference_point)
  {
    const auto values = shape_values(mesh.order, reference_point);
    Point<2>   position;
    for (unsigned int i = 0; i < mesh.n_nodes_per_cell(); ++i)
      position += values[i] * mesh.nodes[mesh.cells[cell][i]];
    return position;
  }



  Point<2>
  middle_of_cell(const TriangleMesh &mesh, const unsigned int cell)
  {
    return position_in_cell(mesh, cell, Point<2>(1. / 3., 1. / 3.));
  }



  void
  evaluate_in_cell(const TriangleMesh &mesh,
                   const MeshField    &field,
                   const unsigned int  cell,
                   const Point<2>     &reference_point,
                   double             *values)
  {
    const auto shapes = shape_values(mesh.order, reference_point);
    std::fill_n(values, field.n_components, 0.);
    for (unsigned int i = 0; i < mesh.n_nodes_per_cell(); ++i)
      for (unsigned int c = 0; c < field.n_components; ++c)
        values[c] += shapes[i] * field.at(mesh.cells[cell][i])[c];
  }



  Tensor<2, 2>
  jacobian_in_cell(const TriangleMesh &mesh,
                   const unsigned int  cell,
                   const Point<2>     &reference_point)
  {
    const auto   gradients = shape_gradients(mesh.order, reference_point);
    Tensor<2, 2> jacobian;
    for (unsigned int i = 0; i < mesh.n_nodes_per_cell(); ++i)
      jacobian += outer_product(Tensor<1, 2>(mesh.nodes[mesh.cells[cell][i]]),
                                gradients[i]);
    return jacobian;
  }



  std::vector<Point<2>>
  quadrature_positions(const TriangleMesh  &mesh,
                       const Quadrature<2> &quadrature)
  {
    std::vector<Point<2>> positions;
    positions.reserve(mesh.cells.size() * quadrature.size());
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      for (const Point<2> &point : quadrature.get_points())
        positions.push_back(position_in_cell(mesh, cell, point));
    return positions;
  }



  std::vector<double>
  quadrature_volumes(const TriangleMesh  &mesh,
                     const Quadrature<2> &quadrature,
                     const Depth         &depth)
  {
    std::vector<double> volumes;
    volumes.reserve(mesh.cells.size() * quadrature.size());
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const Point<2> &point = quadrature.point(q);
          volumes.push_back(quadrature.weight(q) *
                            determinant(jacobian_in_cell(mesh, cell, point)) *
                            depth(position_in_cell(mesh, cell, point)));
        }
    return volumes;
  }



  std::vector<double>
  cell_areas(const TriangleMesh &mesh)
  {
    std::vector<double> areas(mesh.cells.size(), 0.);
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      for (unsigned int edge = 0; edge < 3; ++edge)
        // Seen from one of the corners, so that far from the origin no digits
        // are lost.
        areas[cell] += swept_area(mesh.edge_points(cell, edge),
                                  mesh.nodes[mesh.cells[cell][0]]);
    return areas;
  }
} // namespace Sandglass
