#ifndef sandglass_particles_triangle_shape_h
#define sandglass_particles_triangle_shape_h

#include <sandglass/particles/cell_shape.h>

#include <algorithm>

namespace Sandglass
{
  template <>
  class CellShape<CellType::triangle>
  {
  public:
    static constexpr int dim = 2;

    /// Two coordinates or components, of one particle or of Lanes of them.
    template <typename Number>
    using Pair = std::array<Number, dim>;

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

    /// The gradients are the same at all points.
    template <typename Number>
    std::array<Pair<double>, n_nodes>
    shape_gradients(const Pair<Number> &) const
    {
      return {{components_of<dim>(-(gradients[0] + gradients[1])),
               components_of<dim>(gradients[0]),
               components_of<dim>(gradients[1])}};
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

    /// The start makes no difference.
    template <typename Number>
    Pair<Number>
    to_reference(const Pair<Number> &point, const Pair<Number> &) const
    {
      return to_reference(point);
    }

    static std::array<double, n_nodes>
    shape_values(const Point<dim> &reference_point)
    {
      return shape_values(components_of<dim>(reference_point));
    }

    std::array<Pair<double>, n_nodes>
    shape_gradients(const Point<dim> &reference_point) const
    {
      return shape_gradients(components_of<dim>(reference_point));
    }

    Point<dim>
    to_reference(const Point<dim> &point) const
    {
      const Pair<double> result = to_reference(components_of<dim>(point));
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
      return face_distances(components_of<dim>(reference_point));
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
} // namespace Sandglass

#endif
