#ifndef sandglass_particles_cell_shape_h
#define sandglass_particles_cell_shape_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

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
   * members:
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

    static std::array<double, n_nodes>
    shape_values(const Point<dim> &reference_point)
    {
      return {{1. - reference_point[0] - reference_point[1],
               reference_point[0],
               reference_point[1]}};
    }

    std::array<Tensor<1, dim>, n_nodes>
    shape_gradients(const Point<dim> &) const
    {
      return {{-(gradients[0] + gradients[1]), gradients[0], gradients[1]}};
    }

    Point<dim>
    to_reference(const Point<dim> &point) const
    {
      const Tensor<1, dim> distance = point - origin;
      return {gradients[0] * distance, gradients[1] * distance};
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
    static std::array<double, n_faces>
    face_distances(const Point<dim> &reference_point)
    {
      return {{reference_point[1],
               1. - reference_point[0] - reference_point[1],
               reference_point[0]}};
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

    static std::array<double, n_nodes>
    shape_values(const Point<dim> &reference_point)
    {
      const double x = reference_point[0], y = reference_point[1];
      return {{(1. - x) * (1. - y), x * (1. - y), (1. - x) * y, x * y}};
    }

    std::array<Tensor<1, dim>, n_nodes>
    shape_gradients(const Point<dim> &reference_point) const
    {
      const double         x = reference_point[0], y = reference_point[1];
      const Tensor<1, dim> a = slope_x + y * twist, b = slope_y + x * twist;
      const double         scale = 1. / (a[0] * b[1] - a[1] * b[0]);
      const Tensor<1, dim> gradient_x({b[1] * scale, -b[0] * scale});
      const Tensor<1, dim> gradient_y({-a[1] * scale, a[0] * scale});
      return {{-(1. - y) * gradient_x - (1. - x) * gradient_y,
               (1. - y) * gradient_x - x * gradient_y,
               -y * gradient_x + (1. - x) * gradient_y,
               y * gradient_x + x * gradient_y}};
    }

    /// Newton's method; one iteration in parallelograms, where it is exact.
    Point<dim>
    to_reference(const Point<dim> &point) const
    {
      Point<dim>         result(0.5, 0.5);
      const unsigned int n_iterations = is_parallelogram ? 1 : 20;
      for (unsigned int i = 0; i < n_iterations; ++i)
        {
          const Tensor<1, dim> residual = point - to_real(result);
          const Tensor<1, dim> a        = slope_x + result[1] * twist;
          const Tensor<1, dim> b        = slope_y + result[0] * twist;
          const double         scale    = 1. / (a[0] * b[1] - a[1] * b[0]);
          const Tensor<1, dim> change(
            {(b[1] * residual[0] - b[0] * residual[1]) * scale,
             (a[0] * residual[1] - a[1] * residual[0]) * scale});
          result += change;
          if (std::abs(change[0]) + std::abs(change[1]) < 1e-14)
            break;
        }
      return result;
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

    static std::array<double, n_faces>
    face_distances(const Point<dim> &reference_point)
    {
      const double x = reference_point[0], y = reference_point[1];
      return {{x, 1. - x, y, 1. - y}};
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
    Point<dim>     origin;
    Tensor<1, dim> slope_x, slope_y, twist;
    bool           is_parallelogram;
  };
} // namespace Sandglass

#endif
