#ifndef sandglass_particles_hexahedron_shape_h
#define sandglass_particles_hexahedron_shape_h

#include <sandglass/particles/cell_shape.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  template <>
  class CellShape<CellType::hexahedron>
  {
  public:
    static constexpr int dim = 3;

    /// Coordinates or components, of one particle or of Lanes of them.
    template <typename Number>
    using Vector = std::array<Number, dim>;

    static constexpr unsigned int n_nodes        = 8;
    static constexpr unsigned int n_faces        = 6;
    static constexpr double       reference_area = 1.;

    static constexpr unsigned int face_nodes[n_faces][4] = {{0, 2, 4, 6},
                                                            {1, 3, 5, 7},
                                                            {0, 4, 1, 5},
                                                            {2, 6, 3, 7},
                                                            {0, 1, 2, 3},
                                                            {4, 5, 6, 7}};

    CellShape() = default;

    explicit CellShape(const std::array<Point<dim>, n_nodes> &vertices)
      : origin(vertices[0])
      , slope_x(vertices[1] - vertices[0])
      , slope_y(vertices[2] - vertices[0])
      , slope_z(vertices[4] - vertices[0])
      , twist_xy(vertices[3] - vertices[2] - slope_x)
      , twist_yz(vertices[6] - vertices[4] - slope_y)
      , twist_xz(vertices[5] - vertices[4] - slope_x)
      , twist_xyz(vertices[7] - vertices[6] - slope_x - twist_xy - twist_xz)
      , relative_twist(
          std::max({twist_xy.norm(),
                    twist_yz.norm(),
                    twist_xz.norm(),
                    twist_xyz.norm()}) /
          std::min({slope_x.norm(), slope_y.norm(), slope_z.norm()}))
    {}

    template <typename Number>
    static std::array<Number, n_nodes>
    shape_values(const Vector<Number> &reference_point)
    {
      const auto    in_plane = products(reference_point[0], reference_point[1]);
      const Number &z        = reference_point[2];
      const Number  rest_z   = Number(1.) - z;
      std::array<Number, n_nodes> values;
      for (unsigned int i = 0; i < 4; ++i)
        {
          values[i]     = in_plane[i] * rest_z;
          values[i + 4] = in_plane[i] * z;
        }
      return values;
    }

    /// Gradients of the three reference coordinates, in 1/m.
    template <typename Number>
    std::array<Vector<Number>, dim>
    reference_gradients(const Vector<Number> &reference_point) const
    {
      const std::array<Vector<Number>, dim> a  = slopes(reference_point);
      const Vector<Number>                  yz = cross(a[1], a[2]);
      const Number                          scale =
        Number(1.) / (a[0][0] * yz[0] + a[0][1] * yz[1] + a[0][2] * yz[2]);
      std::array<Vector<Number>, dim> result{
        {yz, cross(a[2], a[0]), cross(a[0], a[1])}};
      for (Vector<Number> &gradient : result)
        for (Number &component : gradient)
          component *= scale;
      return result;
    }

    /**
     * Derivatives of the shape functions along a direction of the reference
     * cell. They are linear in it: to multiply all nodes' gradients by a factor
     * costs less if the direction is multiplied by it.
     */
    template <typename Number>
    static std::array<Number, n_nodes>
    derivatives_along(const Vector<Number> &direction,
                      const Vector<Number> &reference_point)
    {
      const Number &x = reference_point[0], &y = reference_point[1],
                   &z = reference_point[2];
      // Of the edges along each axis, in the order of the nodes.
      const auto of_x = products(y, z), of_y = products(x, z),
                 of_z = products(x, y);
      std::array<Number, n_nodes> result;
      for (unsigned int i = 0; i < n_nodes; ++i)
        {
          const unsigned int i_x = i % 2, i_y = i / 2 % 2, i_z = i / 4;
          const Number       along_x = direction[0] * of_x[i_y + 2 * i_z],
                       along_y       = direction[1] * of_y[i_x + 2 * i_z],
                       along_z       = direction[2] * of_z[i_x + 2 * i_y];
          result[i]                  = i_x == 1 ? along_x : -along_x;
          result[i] += i_y == 1 ? along_y : -along_y;
          result[i] += i_z == 1 ? along_z : -along_z;
        }
      return result;
    }

    template <typename Number>
    std::array<Vector<Number>, n_nodes>
    shape_gradients(const Vector<Number> &reference_point) const
    {
      const auto gradients = reference_gradients(reference_point);
      std::array<Vector<Number>, n_nodes> result;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const Vector<Number> direction{
            {gradients[0][d], gradients[1][d], gradients[2][d]}};
          const auto values = derivatives_along(direction, reference_point);
          for (unsigned int i = 0; i < n_nodes; ++i)
            result[i][d] = values[i];
        }
      return result;
    }

    /// sum_i v_i dN_i/dx of three components at each node: row d is the
    /// gradient of component d.
    template <typename Number>
    std::array<Vector<Number>, dim>
    gradient_of(const std::array<Vector<double>, n_nodes> &v,
                const Vector<Number> &reference_point) const
    {
      const Number &x = reference_point[0], &y = reference_point[1],
                   &z = reference_point[2];
      const auto of_x = products(y, z), of_y = products(x, z),
                 of_z      = products(x, y);
      const auto gradients = reference_gradients(reference_point);
      std::array<Vector<Number>, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        {
          Number along_x(0.), along_y(0.), along_z(0.);
          for (unsigned int i = 0; i < 4; ++i)
            {
              const unsigned int low = i % 2, high = i / 2;
              along_x += of_x[i] * (v[2 * i + 1][d] - v[2 * i][d]);
              along_y +=
                of_y[i] * (v[low + 4 * high + 2][d] - v[low + 4 * high][d]);
              along_z += of_z[i] * (v[i + 4][d] - v[i][d]);
            }
          for (unsigned int e = 0; e < dim; ++e)
            result[d][e] = along_x * gradients[0][e] +
                           along_y * gradients[1][e] +
                           along_z * gradients[2][e];
        }
      return result;
    }

    /**
     * Newton's method. The error of an iteration is made of the twists times
     * products of the coordinates' changes. So one iteration is enough in
     * parallelepipeds and, from a start nearby, in those that a mesh generator
     * has rounded.
     */
    template <typename Number>
    Vector<Number>
    to_reference(const Vector<Number> &point, const Vector<Number> &start) const
    {
      using std::abs;
      constexpr unsigned int max_iterations = 20;
      constexpr double       tolerance      = 1e-16;
      const auto             error          = [](const Vector<Number> &change) {
        return abs(change[0] * change[1]) + abs(change[1] * change[2]) +
               abs(change[0] * change[2]);
      };
      // The first iteration stands alone, so that the compiler sees that it
      // needs the same gradients as other code that needs them at the start.
      Vector<Number> change = newton_change(point, start);
      Vector<Number> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = start[d] + change[d];
      for (unsigned int i = 1;
           i < max_iterations &&
           any(relative_twist * error(change) > Number(tolerance));
           ++i)
        {
          change = newton_change(point, result);
          for (unsigned int d = 0; d < dim; ++d)
            result[d] += change[d];
        }
      return result;
    }

    template <typename Number>
    Vector<Number>
    to_reference(const Vector<Number> &point) const
    {
      return to_reference(
        point, Vector<Number>{{Number(0.5), Number(0.5), Number(0.5)}});
    }

    static std::array<double, n_nodes>
    shape_values(const Point<dim> &reference_point)
    {
      return shape_values(components_of<dim>(reference_point));
    }

    std::array<Vector<double>, n_nodes>
    shape_gradients(const Point<dim> &reference_point) const
    {
      return shape_gradients(components_of<dim>(reference_point));
    }

    Point<dim>
    to_reference(const Point<dim> &point) const
    {
      return point_of(to_reference(components_of<dim>(point)));
    }

    Point<dim>
    to_real(const Point<dim> &reference_point) const
    {
      const double x = reference_point[0], y = reference_point[1],
                   z = reference_point[2];
      return origin + x * slope_x + y * slope_y + z * slope_z +
             x * y * twist_xy + y * z * twist_yz + x * z * twist_xz +
             x * y * z * twist_xyz;
    }

    Point<dim>
    node(const unsigned int i) const
    {
      return to_real(Point<dim>(i % 2, i / 2 % 2, i / 4));
    }

    double
    jacobian(const Point<dim> &reference_point) const
    {
      const auto a     = slopes(components_of<dim>(reference_point));
      const auto cross = CellShape::cross(a[1], a[2]);
      return a[0][0] * cross[0] + a[0][1] * cross[1] + a[0][2] * cross[2];
    }

    template <typename Number>
    static std::array<Number, n_faces>
    face_distances(const Vector<Number> &reference_point)
    {
      const Number &x = reference_point[0], &y = reference_point[1],
                   &z = reference_point[2];
      return {{x, Number(1.) - x, y, Number(1.) - y, z, Number(1.) - z}};
    }

    static std::array<double, n_faces>
    face_distances(const Point<dim> &reference_point)
    {
      return face_distances(components_of<dim>(reference_point));
    }

    /// Next to the cell the reference coordinates', so that cells beside a face
    /// that isn't plane agree on who has a point; elsewhere those to the faces'
    /// mean planes.
    std::array<double, n_faces>
    walk_distances(const Point<dim> &point) const
    {
      constexpr double nearby = -0.25;

      const auto to_planes = plane_distances(point);
      if (*std::min_element(to_planes.begin(), to_planes.end()) < nearby)
        return to_planes;
      const Point<dim> reference_point = to_reference(point);
      const bool       is_far          = !(reference_point.norm_square() < 1e2);
      return is_far ? to_planes : face_distances(reference_point);
    }

    static Point<dim>
    clamp(const Point<dim> &reference_point, const double margin)
    {
      Point<dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = std::clamp(reference_point[d], margin, 1. - margin);
      return result;
    }

  private:
    /// Bilinear shape functions of four nodes, the first coordinate's running
    /// first.
    template <typename Number>
    static std::array<Number, 4>
    products(const Number &x, const Number &y)
    {
      const Number rest_x = Number(1.) - x, rest_y = Number(1.) - y;
      return {{rest_x * rest_y, x * rest_y, rest_x * y, x * y}};
    }

    template <typename Number>
    static Vector<Number>
    cross(const Vector<Number> &a, const Vector<Number> &b)
    {
      return {{a[1] * b[2] - a[2] * b[1],
               a[2] * b[0] - a[0] * b[2],
               a[0] * b[1] - a[1] * b[0]}};
    }

    /// Derivatives of the position with respect to the reference coordinates.
    template <typename Number>
    std::array<Vector<Number>, dim>
    slopes(const Vector<Number> &reference_point) const
    {
      const Number &x = reference_point[0], &y = reference_point[1],
                   &z                    = reference_point[2];
      const Number                    xy = x * y, yz = y * z, xz = x * z;
      std::array<Vector<Number>, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        {
          result[0][d] =
            slope_x[d] + twist_xy[d] * y + twist_xz[d] * z + twist_xyz[d] * yz;
          result[1][d] =
            slope_y[d] + twist_xy[d] * x + twist_yz[d] * z + twist_xyz[d] * xz;
          result[2][d] =
            slope_z[d] + twist_xz[d] * x + twist_yz[d] * y + twist_xyz[d] * xy;
        }
      return result;
    }

    /// Change of the reference coordinates in an iteration.
    template <typename Number>
    Vector<Number>
    newton_change(const Vector<Number> &point,
                  const Vector<Number> &reference_point) const
    {
      const Vector<Number> residual  = distance_to(point, reference_point);
      const auto           gradients = reference_gradients(reference_point);
      Vector<Number>       change;
      for (unsigned int d = 0; d < dim; ++d)
        change[d] = gradients[d][0] * residual[0] +
                    gradients[d][1] * residual[1] +
                    gradients[d][2] * residual[2];
      return change;
    }

    /// Vector from the position of a reference point to `point`.
    template <typename Number>
    Vector<Number>
    distance_to(const Vector<Number> &point,
                const Vector<Number> &reference_point) const
    {
      const Number &x = reference_point[0], &y = reference_point[1],
                   &z   = reference_point[2];
      const Number   xy = x * y;
      Vector<Number> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = point[d] - (origin[d] + x * slope_x[d] + y * slope_y[d] +
                                xy * twist_xy[d] +
                                z * (slope_z[d] + y * twist_yz[d] +
                                     x * twist_xz[d] + xy * twist_xyz[d]));
      return result;
    }

    /// To the plane through each face's middle and along both of its diagonals,
    /// over the distance of the opposite face's middle.
    std::array<double, n_faces>
    plane_distances(const Point<dim> &point) const
    {
      std::array<double, n_faces> distances;
      for (unsigned int face = 0; face < n_faces; ++face)
        {
          const auto &corners  = face_nodes[face];
          const auto &opposite = face_nodes[face ^ 1u];

          Tensor<1, dim> middle, other_middle;
          for (unsigned int v = 0; v < 4; ++v)
            {
              middle += 0.25 * node(corners[v]);
              other_middle += 0.25 * node(opposite[v]);
            }
          const Tensor<1, dim> normal =
            cross_product_3d(node(corners[3]) - node(corners[0]),
                             node(corners[2]) - node(corners[1]));
          distances[face] = (normal * (point - Point<dim>(middle))) /
                            (normal * (other_middle - middle));
        }
      return distances;
    }

    Point<dim>     origin;
    Tensor<1, dim> slope_x, slope_y, slope_z;
    Tensor<1, dim> twist_xy, twist_yz, twist_xz, twist_xyz;
    double         relative_twist; ///< the largest, over the shortest slope
  };
} // namespace Sandglass

#endif
