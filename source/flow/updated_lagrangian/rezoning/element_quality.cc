#include <deal.II/base/quadrature_lib.h>

#include <sandglass/flow/updated_lagrangian/rezoning/boundary_piece.h>
#include <sandglass/flow/updated_lagrangian/rezoning/element_quality.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_element.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace Sandglass
{
  namespace
  {
    std::vector<Point<2>>
    make_checked_points()
    {
      std::vector<Point<2>> points(reference_nodes.begin(),
                                   reference_nodes.end());
      for (unsigned int n = 1; n <= 3; ++n)
        {
          const QGaussSimplex<2> quadrature(n);
          points.insert(points.end(),
                        quadrature.get_points().begin(),
                        quadrature.get_points().end());
        }
      return points;
    }
  } // namespace



  double
  jacobian_ratio(const TriangleMesh &mesh, const unsigned int cell)
  {
    static const std::vector<Point<2>> points = make_checked_points();

    double smallest = std::numeric_limits<double>::max(), largest = 0.;
    for (const Point<2> &point : points)
      {
        const double value = determinant(jacobian_in_cell(mesh, cell, point));
        smallest           = std::min(smallest, value);
        largest            = std::max(largest, std::abs(value));
      }
    return largest > 0. ? smallest / largest : 0.;
  }



  double
  smallest_angle(const TriangleMesh &mesh, const unsigned int cell)
  {
    double smallest = numbers::PI;
    for (unsigned int v = 0; v < 3; ++v)
      {
        const Tensor<1, 2> leaving =
          derivative_on_curve(mesh.edge_points(cell, v), 0.);
        const Tensor<1, 2> arriving =
          derivative_on_curve(mesh.edge_points(cell, (v + 2) % 3), 1.);
        smallest =
          std::min(smallest,
                   std::atan2(cross(arriving, leaving), -(arriving * leaving)));
      }
    return smallest;
  }
} // namespace Sandglass
