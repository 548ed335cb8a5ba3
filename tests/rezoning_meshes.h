#ifndef sandglass_tests_rezoning_meshes_h
#define sandglass_tests_rezoning_meshes_h

#include <deal.II/base/quadrature_lib.h>

#include <sandglass/flow/updated_lagrangian/rezoning/mesh_outlines.h>
#include <sandglass/flow/updated_lagrangian/rezoning/rezone.h>

#include <cmath>
#include <functional>
#include <vector>

#include "random_engine.h"

namespace RezoningTest
{
  using namespace Sandglass;

  inline double
  plane(const Point<2> &)
  {
    return 1.;
  }

  /// Straight edges through these corners, of which those from the first to
  /// the second corner have mark 0, and so on.
  inline BoundaryLoop
  polygon(const std::vector<Point<2>> &corners)
  {
    BoundaryLoop loop;
    for (unsigned int i = 0; i < corners.size(); ++i)
      {
        const Point<2> &a = corners[i], &b = corners[(i + 1) % corners.size()];
        loop.push_back({{{a, b, a + (b - a) / 2.}}, i, true});
      }
    return loop;
  }

  /// A free circle of n quadratic edges.
  inline BoundaryLoop
  circle(const Point<2> &centre, const double radius, const unsigned int n)
  {
    const auto on_circle = [&](const double i) {
      const double angle = 2. * numbers::PI * i / n;
      return centre + radius * Point<2>(std::cos(angle), std::sin(angle));
    };
    BoundaryLoop loop;
    for (unsigned int i = 0; i < n; ++i)
      loop.push_back(
        {{{on_circle(i), on_circle((i + 1) % n), on_circle(i + 0.5)}},
         TriangleMesh::free_surface,
         false});
    return loop;
  }

  /// The same, seen from outside.
  inline BoundaryLoop
  reversed(const BoundaryLoop &loop)
  {
    BoundaryLoop result;
    for (auto piece = loop.rbegin(); piece != loop.rend(); ++piece)
      {
        const auto &[start, end, middle] = piece->curve;
        result.push_back({{{end, start, middle}}, piece->mark, true});
      }
    return result;
  }

  inline BodyOutline
  square(const Point<2> &lower = Point<2>(), const double width = 1.)
  {
    const Point<2> x(width, 0.), y(0., width);
    return {polygon({lower, lower + x, lower + x + y, lower + y}), {}};
  }

  inline TriangleMesh
  mesh_of(const BodyOutline &outline,
          const double       size,
          const unsigned int order = 2)
  {
    return mesh_outlines({outline}, {size}, order).mesh;
  }

  using ScalarFunction = std::function<double(const Point<2> &)>;

  /// Functions' values at points.
  inline MeshField
  values_at(const std::vector<Point<2>>       &points,
            const std::vector<ScalarFunction> &functions)
  {
    MeshField field = MeshField::zero(functions.size(), points.size());
    for (unsigned int i = 0; i < points.size(); ++i)
      for (unsigned int c = 0; c < functions.size(); ++c)
        field.at(i)[c] = functions[c](points[i]);
    return field;
  }

  inline double
  largest_difference(const MeshField &a, const MeshField &b)
  {
    double largest = 0.;
    for (unsigned int i = 0; i < a.values.size(); ++i)
      largest = std::max(largest, std::abs(a.values[i] - b.values[i]));
    return largest;
  }

  /// Root of the mean square difference.
  inline double
  mean_difference(const MeshField &a, const MeshField &b)
  {
    double sum = 0.;
    for (unsigned int i = 0; i < a.values.size(); ++i)
      sum += std::pow(a.values[i] - b.values[i], 2);
    return std::sqrt(sum / a.values.size());
  }

  /// Material with given fields. Density 1000 (1 + x^2/10) kg/m^3.
  inline MeshState
  make_state(const TriangleMesh                &mesh,
             const Quadrature<2>               &quadrature,
             const std::vector<ScalarFunction> &velocity,
             const std::vector<ScalarFunction> &point_fields)
  {
    const auto points = quadrature_positions(mesh, quadrature);
    MeshState  state;
    state.mesh         = mesh;
    state.velocity     = values_at(mesh.nodes, velocity);
    state.nodal_fields = values_at(mesh.nodes, velocity);
    state.density      = values_at(points, {[](const Point<2> &p) {
                                return 1000. * (1. + 0.1 * p[0] * p[0]);
                              }})
                      .values;
    state.point_fields = values_at(points, point_fields);
    return state;
  }

  inline RezoningOptions
  options_of_size(const double size)
  {
    RezoningOptions options;
    options.size       = {size};
    options.quadrature = QGaussSimplex<2>(2);
    options.depth      = plane;
    return options;
  }
} // namespace RezoningTest

#endif
