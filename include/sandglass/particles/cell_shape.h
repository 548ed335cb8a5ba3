#ifndef sandglass_particles_cell_shape_h
#define sandglass_particles_cell_shape_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <sandglass/base/lanes.h>
#include <sandglass/base/setting.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Sandglass
{
  using namespace dealii;

  /**
   * Geometry and linear shape functions of one cell, in the numbering of
   * deal.II's reference cells. Specialised for each cell type with the same
   * members, of which the first three also take the points of Lanes of
   * particles:
   *
   * - shape_values(reference_point): N_i, one per node;
   * - shape_gradients(reference_point): dN_i/dx in 1/m;
   * - to_reference(point): reference coordinates of a point in or near the
   * cell;
   * - to_real(reference_point): its position in m;
   * - node(i): position of node i in m;
   * - jacobian(reference_point): area per reference area, in m^2;
   * - face_distances(reference_point): for each face a number that is negative
   *   beyond it and grows inwards, 0 on it, of the order of 1 across the cell;
   * - walk_distances(point): the same for any point of the plane, also where a
   *   quadrilateral's reference coordinates don't exist.
   */
  template <CellType cell_type>
  class CellShape;

  /// Two coordinates or components, of one particle or of Lanes of them.
  template <typename Number>
  using Pair = std::array<Number, dim>;

  inline Pair<double>
  pair_of(const Tensor<1, dim> &tensor)
  {
    return {{tensor[0], tensor[1]}};
  }

  template <>
  class CellShape<CellType::triangle>
  {
  public:
    static constexpr unsigned int n_nodes        = 3;
    static constexpr unsigned int n_faces        = 3;
    static constexpr double       reference_area = 0.5;

    /// Nodes at the ends of each face.
    static constexpr unsigned int face_nodes[n_faces][2] = {{0, 1},
                                                            {1, 2},
                                                            {2, 0}};

    CellShape() = default;

    explicit CellShape(const std::array<Point<dim>, n_nodes> &vertices)
      : origin(vertices[0])
    {
      const Tensor<1, dim> a = vertices[1] - vertices[0];
      const Tensor<1, dim> b = vertices[2] - vertices[0];
      determinant            = a[0] * b[1] - a[1] * b[0];
      gradients[0]           = Tensor<1, dim>{{b[1], -b[0]}} / determinant;
      gradients[1]           = Tensor<1, dim>{{-a[1], a[0]}} / determinant;
    }

    template <typename Number>
    static std::array<Number, n_nodes>
    shape_values(const Pair<Number> &reference_point)
    {
      return {{Number(1.) - reference_point[0] - reference_point[1],
               reference_point[0],
               reference_point[1]}};
    }

    /// The same at all points.
    template <typename Number>
    std::array<Pair<double>, n_nodes>
    shape_gradients(const Pair<Number> &) const
    {
      return {{pair_of(-(gradients[0] + gradients[1])),
               pair_of(gradients[0]),
               pair_of(gradients[1])}};
    }

    template <typename Number>
    Pair<Number>
    to_reference(const Pair<Number> &point) const
    {
      const Number x = point[0] - Number(origin[0]);
      const Number y = point[1] - Number(origin[1]);
      return {{gradients[0][0] * x + gradients[0][1] * y,
               gradients[1][0] * x + gradients[1][1] * y}};
    }

    static std::array<double, n_nodes>
    shape_values(const Point<dim> &reference_point)
    {
      return shape_values(pair_of(reference_point));
    }

    std::array<Pair<double>, n_nodes>
    shape_gradients(const Point<dim> &reference_point) const
    {
      return shape_gradients(pair_of(reference_point));
    }

    Point<dim>
    to_reference(const Point<dim> &point) const
    {
      const Pair<double> result = to_reference(pair_of(point));
      return {result[0], result[1]};
    }

    Point<dim>
    to_real(const Point<dim> &reference_point) const
    {
      // The columns of the Jacobian matrix from the rows of its inverse.
      const double x = reference_point[0], y = reference_point[1];
      return {origin[0] +
                determinant * (gradients[1][1] * x - gradients[0][1] * y),
              origin[1] +
                determinant * (-gradients[1][0] * x + gradients[0][0] * y)};
    }

    Point<dim>
    node(const unsigned int i) const
    {
      return to_real(Point<dim>(i == 1 ? 1. : 0., i == 2 ? 1. : 0.));
    }

    double
    jacobian(const Point<dim> &) const
    {
      return determinant;
    }

    /// Barycentric coordinates, in deal.II's order of faces: face 0 joins nodes
    /// 0 and 1, face 1 nodes 1 and 2, face 2 nodes 2 and 0.
    template <typename Number>
    static std::array<Number, n_faces>
    face_distances(const Pair<Number> &reference_point)
    {
      return {{reference_point[1],
               Number(1.) - reference_point[0] - reference_point[1],
               reference_point[0]}};
    }

    static std::array<double, n_faces>
    face_distances(const Point<dim> &reference_point)
    {
      return face_distances(pair_of(reference_point));
    }

    std::array<double, n_faces>
    walk_distances(const Point<dim> &point) const
    {
      return face_distances(to_reference(point));
    }

    /// The nearest reference point whose face distances are at least `margin`.
    static Point<dim>
    clamp(const Point<dim> &reference_point, const double margin)
    {
      Point<dim>   result(std::max(reference_point[0], margin),
                        std::max(reference_point[1], margin));
      const double excess = result[0] + result[1] - (1. - margin);
      if (excess > 0.)
        {
          // Shorten the longer coordinate, so that the shorter stays positive.
          double &longer = result[0] > result[1] ? result[0] : result[1];
          longer -= excess;
        }
      return result;
    }

  private:
    Point<dim>                    origin;
    std::array<Tensor<1, dim>, 2> gradients; ///< of nodes 1 and 2, in 1/m
    double                        determinant;
  };



  template <>
  class CellShape<CellType::quadrilateral>
  {
  public:
    static constexpr unsigned int n_nodes        = 4;
    static constexpr unsigned int n_faces        = 4;
    static constexpr double       reference_area = 1.;

    static constexpr unsigned int face_nodes[n_faces][2] = {{0, 2},
                                                            {1, 3},
                                                            {0, 1},
                                                            {2, 3}};

    CellShape() = default;

    explicit CellShape(const std::array<Point<dim>, n_nodes> &vertices)
      : origin(vertices[0])
      , slope_x(vertices[1] - vertices[0])
      , slope_y(vertices[2] - vertices[0])
      , twist(vertices[3] - vertices[2] - slope_x)
      , is_parallelogram(twist.norm() <=
                         1e-13 * (slope_x.norm() + slope_y.norm()))
    {}

    template <typename Number>
    static std::array<Number, n_nodes>
    shape_values(const Pair<Number> &reference_point)
    {
      const Number x = reference_point[0], y = reference_point[1];
      const Number rest_x = Number(1.) - x, rest_y = Number(1.) - y;
      return {{rest_x * rest_y, x * rest_y, rest_x * y, x * y}};
    }

    template <typename Number>
    std::array<Pair<Number>, n_nodes>
    shape_gradients(const Pair<Number> &reference_point) const
    {
      const Number       x = reference_point[0], y = reference_point[1];
      const Number       rest_x = Number(1.) - x, rest_y = Number(1.) - y;
      const Pair<Number> a     = slope(slope_x, y);
      const Pair<Number> b     = slope(slope_y, x);
      const Number       scale = Number(1.) / (a[0] * b[1] - a[1] * b[0]);
      std::array<Pair<Number>, n_nodes> result;
      // d/dx is the gradient of the first reference coordinate, d/dy of the
      // second one.
      const Pair<Number> of_x{{b[1] * scale, -b[0] * scale}};
      const Pair<Number> of_y{{-a[1] * scale, a[0] * scale}};
      for (unsigned int d = 0; d < dim; ++d)
        {
          result[0][d] = -rest_y * of_x[d] - rest_x * of_y[d];
          result[1][d] = rest_y * of_x[d] - x * of_y[d];
          result[2][d] = rest_x * of_y[d] - y * of_x[d];
          result[3][d] = y * of_x[d] + x * of_y[d];
        }
      return result;
    }

    /// Newton's method; one iteration in parallelograms, where it is exact.
    template <typename Number>
    Pair<Number>
    to_reference(const Pair<Number> &point) const
    {
      using std::abs;
      Pair<Number>       result{{Number(0.5), Number(0.5)}};
      const unsigned int n_iterations = is_parallelogram ? 1 : 20;
      for (unsigned int i = 0; i < n_iterations; ++i)
        {
          const Pair<Number> residual = distance_to(point, result);
          const Pair<Number> a        = slope(slope_x, result[1]);
          const Pair<Number> b        = slope(slope_y, result[0]);
          const Number       scale = Number(1.) / (a[0] * b[1] - a[1] * b[0]);
          const Pair<Number> change{
            {(b[1] * residual[0] - b[0] * residual[1]) * scale,
             (a[0] * residual[1] - a[1] * residual[0]) * scale}};
          for (unsigned int d = 0; d < dim; ++d)
            result[d] += change[d];
          if (!any(abs(change[0]) + abs(change[1]) > Number(1e-14)))
            break;
        }
      return result;
    }

    static std::array<double, n_nodes>
    shape_values(const Point<dim> &reference_point)
    {
      return shape_values(pair_of(reference_point));
    }

    std::array<Pair<double>, n_nodes>
    shape_gradients(const Point<dim> &reference_point) const
    {
      return shape_gradients(pair_of(reference_point));
    }

    Point<dim>
    to_reference(const Point<dim> &point) const
    {
      const Pair<double> result = to_reference(pair_of(point));
      return {result[0], result[1]};
    }

    Point<dim>
    to_real(const Point<dim> &reference_point) const
    {
      const double x = reference_point[0], y = reference_point[1];
      return origin + x * slope_x + y * slope_y + x * y * twist;
    }

    Point<dim>
    node(const unsigned int i) const
    {
      return to_real(Point<dim>(i % 2, i / 2));
    }

    double
    jacobian(const Point<dim> &reference_point) const
    {
      const Tensor<1, dim> a = slope_x + reference_point[1] * twist;
      const Tensor<1, dim> b = slope_y + reference_point[0] * twist;
      return a[0] * b[1] - a[1] * b[0];
    }

    template <typename Number>
    static std::array<Number, n_faces>
    face_distances(const Pair<Number> &reference_point)
    {
      const Number x = reference_point[0], y = reference_point[1];
      return {{x, Number(1.) - x, y, Number(1.) - y}};
    }

    static std::array<double, n_faces>
    face_distances(const Point<dim> &reference_point)
    {
      return face_distances(pair_of(reference_point));
    }

    std::array<double, n_faces>
    walk_distances(const Point<dim> &point) const
    {
      // The cell lies to the right of faces 0 and 3, to the left of 1 and 2.
      constexpr double            side[n_faces] = {-1., 1., 1., -1.};
      std::array<double, n_faces> distances;
      for (unsigned int face = 0; face < n_faces; ++face)
        {
          const Point<dim>     start = node(face_nodes[face][0]);
          const Tensor<1, dim> edge  = node(face_nodes[face][1]) - start;
          const Tensor<1, dim> way   = point - start;
          distances[face] = side[face] * (edge[0] * way[1] - edge[1] * way[0]) /
                            edge.norm_square();
        }
      return distances;
    }

    static Point<dim>
    clamp(const Point<dim> &reference_point, const double margin)
    {
      return {std::clamp(reference_point[0], margin, 1. - margin),
              std::clamp(reference_point[1], margin, 1. - margin)};
    }

  private:
    /// Derivative of the position: a slope plus the twist times the other
    /// reference coordinate.
    template <typename Number>
    Pair<Number>
    slope(const Tensor<1, dim> &at_origin, const Number &other) const
    {
      return {
        {at_origin[0] + twist[0] * other, at_origin[1] + twist[1] * other}};
    }

    /// From the position of a reference point to `point`.
    template <typename Number>
    Pair<Number>
    distance_to(const Pair<Number> &point,
                const Pair<Number> &reference_point) const
    {
      const Number x = reference_point[0], y = reference_point[1];
      Pair<Number> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = point[d] - (origin[d] + x * slope_x[d] + y * slope_y[d] +
                                x * y * twist[d]);
      return result;
    }

    Point<dim>     origin;
    Tensor<1, dim> slope_x, slope_y, twist;
    bool           is_parallelogram;
  };
} // namespace Sandglass

#endif
