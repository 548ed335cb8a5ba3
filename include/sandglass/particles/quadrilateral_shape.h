#ifndef sandglass_particles_quadrilateral_shape_h
#define sandglass_particles_quadrilateral_shape_h

#include <sandglass/particles/cell_shape.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  template <>
  class CellShape<CellType::quadrilateral>
  {
  public:
    static constexpr int dim = 2;

    /// Two coordinates or components, of one particle or of Lanes of them.
    template <typename Number>
    using Pair = std::array<Number, dim>;

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
      , relative_twist(twist.norm() / std::min(slope_x.norm(), slope_y.norm()))
    {}

    template <typename Number>
    static std::array<Number, n_nodes>
    shape_values(const Pair<Number> &reference_point)
    {
      const Number x = reference_point[0], y = reference_point[1];
      const Number rest_x = Number(1.) - x, rest_y = Number(1.) - y;
      return {{rest_x * rest_y, x * rest_y, rest_x * y, x * y}};
    }

    /// Gradients of the two reference coordinates, in 1/m.
    template <typename Number>
    std::array<Pair<Number>, dim>
    reference_gradients(const Pair<Number> &reference_point) const
    {
      const Pair<Number> a     = slope(slope_x, reference_point[1]);
      const Pair<Number> b     = slope(slope_y, reference_point[0]);
      const Number       scale = Number(1.) / (a[0] * b[1] - a[1] * b[0]);
      return {
        {{{b[1] * scale, -b[0] * scale}}, {{-a[1] * scale, a[0] * scale}}}};
    }

    /**
     * Derivatives of the shape functions along a direction of the reference
     * cell. They are linear in it: to multiply all nodes' gradients by a factor
     * costs less if the direction is multiplied by it.
     */
    template <typename Number>
    static std::array<Number, n_nodes>
    derivatives_along(const Pair<Number> &direction,
                      const Pair<Number> &reference_point)
    {
      const Number x = reference_point[0], y = reference_point[1];
      const Number bottom = (Number(1.) - y) * direction[0];
      const Number top    = y * direction[0];
      const Number left   = (Number(1.) - x) * direction[1];
      const Number right  = x * direction[1];
      return {{-bottom - left, bottom - right, left - top, top + right}};
    }

    template <typename Number>
    std::array<Pair<Number>, n_nodes>
    shape_gradients(const Pair<Number> &reference_point) const
    {
      const auto gradients = reference_gradients(reference_point);
      std::array<Pair<Number>, n_nodes> result;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const Pair<Number> direction{{gradients[0][d], gradients[1][d]}};
          const auto values = derivatives_along(direction, reference_point);
          for (unsigned int i = 0; i < n_nodes; ++i)
            result[i][d] = values[i];
        }
      return result;
    }

    /// sum_i v_i dN_i/dx of two components at each node: row d is the gradient
    /// of component d.
    template <typename Number>
    std::array<Pair<Number>, dim>
    gradient_of(const std::array<Pair<double>, n_nodes> &v,
                const Pair<Number>                      &reference_point) const
    {
      const Number x = reference_point[0], y = reference_point[1];
      const Number rest_x = Number(1.) - x, rest_y = Number(1.) - y;
      const auto   gradients = reference_gradients(reference_point);
      std::array<Pair<Number>, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const Number along_x =
            rest_y * (v[1][d] - v[0][d]) + y * (v[3][d] - v[2][d]);
          const Number along_y =
            rest_x * (v[2][d] - v[0][d]) + x * (v[3][d] - v[1][d]);
          for (unsigned int e = 0; e < dim; ++e)
            result[d][e] =
              along_x * gradients[0][e] + along_y * gradients[1][e];
        }
      return result;
    }

    /**
     * Newton's method. The error of an iteration is just the twist times the
     * changes of both coordinates. So one iteration is enough in parallelograms
     * and, from a start nearby, in those that a mesh generator has rounded.
     */
    template <typename Number>
    Pair<Number>
    to_reference(const Pair<Number> &point, const Pair<Number> &start) const
    {
      using std::abs;
      constexpr unsigned int max_iterations = 20;
      constexpr double       tolerance      = 1e-16;
      // The first iteration stands alone, so that the compiler sees that it
      // needs the same gradients as other code that needs them at the start.
      Pair<Number> change = newton_change(point, start);
      Pair<Number> result{{start[0] + change[0], start[1] + change[1]}};
      for (unsigned int i = 1;
           i < max_iterations &&
           any(relative_twist * abs(change[0] * change[1]) > Number(tolerance));
           ++i)
        {
          change = newton_change(point, result);
          for (unsigned int d = 0; d < dim; ++d)
            result[d] += change[d];
        }
      return result;
    }

    template <typename Number>
    Pair<Number>
    to_reference(const Pair<Number> &point) const
    {
      return to_reference(point, Pair<Number>{{Number(0.5), Number(0.5)}});
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
      return face_distances(components_of<dim>(reference_point));
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

    /// Change of the reference coordinates in an iteration.
    template <typename Number>
    Pair<Number>
    newton_change(const Pair<Number> &point,
                  const Pair<Number> &reference_point) const
    {
      const Pair<Number> residual  = distance_to(point, reference_point);
      const auto         gradients = reference_gradients(reference_point);
      return {{gradients[0][0] * residual[0] + gradients[0][1] * residual[1],
               gradients[1][0] * residual[0] + gradients[1][1] * residual[1]}};
    }

    /// Vector from the position of a reference point to `point`.
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
    double         relative_twist; ///< over the shorter slope
  };
} // namespace Sandglass

#endif
