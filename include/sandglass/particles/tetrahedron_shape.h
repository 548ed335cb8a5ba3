#ifndef sandglass_particles_tetrahedron_shape_h
#define sandglass_particles_tetrahedron_shape_h

#include <sandglass/particles/cell_shape.h>

#include <algorithm>

namespace Sandglass
{
  template <>
  class CellShape<CellType::tetrahedron>
  {
  public:
    static constexpr int dim = 3;

    /// Coordinates or components, of one particle or of Lanes of them.
    template <typename Number>
    using Vector = std::array<Number, dim>;

    static constexpr unsigned int n_nodes        = 4;
    static constexpr unsigned int n_faces        = 4;
    static constexpr double       reference_area = 1. / 6.;

    /// Nodes at the corners of each face.
    static constexpr unsigned int face_nodes[n_faces][3] = {{0, 1, 2},
                                                            {1, 0, 3},
                                                            {0, 2, 3},
                                                            {2, 1, 3}};

    CellShape() = default;

    explicit CellShape(const std::array<Point<dim>, n_nodes> &vertices)
      : origin(vertices[0])
    {
      const Tensor<1, dim> a = vertices[1] - vertices[0];
      const Tensor<1, dim> b = vertices[2] - vertices[0];
      const Tensor<1, dim> c = vertices[3] - vertices[0];
      determinant            = a * cross_product_3d(b, c);
      gradients[0]           = cross_product_3d(b, c) / determinant;
      gradients[1]           = cross_product_3d(c, a) / determinant;
      gradients[2]           = cross_product_3d(a, b) / determinant;
    }

    template <typename Number>
    static std::array<Number, n_nodes>
    shape_values(const Vector<Number> &reference_point)
    {
      return {{Number(1.) - reference_point[0] - reference_point[1] -
                 reference_point[2],
               reference_point[0],
               reference_point[1],
               reference_point[2]}};
    }

    /// The gradients are the same at all points.
    template <typename Number>
    std::array<Vector<double>, n_nodes>
    shape_gradients(const Vector<Number> &) const
    {
      return {
        {components_of<dim>(-(gradients[0] + gradients[1] + gradients[2])),
         components_of<dim>(gradients[0]),
         components_of<dim>(gradients[1]),
         components_of<dim>(gradients[2])}};
    }

    template <typename Number>
    Vector<Number>
    to_reference(const Vector<Number> &point) const
    {
      const Number   x = point[0] - Number(origin[0]);
      const Number   y = point[1] - Number(origin[1]);
      const Number   z = point[2] - Number(origin[2]);
      Vector<Number> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] =
          gradients[d][0] * x + gradients[d][1] * y + gradients[d][2] * z;
      return result;
    }

    /// The start makes no difference.
    template <typename Number>
    Vector<Number>
    to_reference(const Vector<Number> &point, const Vector<Number> &) const
    {
      return to_reference(point);
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
      // The columns of the Jacobian matrix from the rows of its inverse.
      return origin +
             determinant * (reference_point[0] *
                              cross_product_3d(gradients[1], gradients[2]) +
                            reference_point[1] *
                              cross_product_3d(gradients[2], gradients[0]) +
                            reference_point[2] *
                              cross_product_3d(gradients[0], gradients[1]));
    }

    Point<dim>
    node(const unsigned int i) const
    {
      return to_real(
        Point<dim>(i == 1 ? 1. : 0., i == 2 ? 1. : 0., i == 3 ? 1. : 0.));
    }

    double
    jacobian(const Point<dim> &) const
    {
      return determinant;
    }

    /// Barycentric coordinates, in deal.II's order of faces.
    template <typename Number>
    static std::array<Number, n_faces>
    face_distances(const Vector<Number> &reference_point)
    {
      return {{reference_point[2],
               reference_point[1],
               reference_point[0],
               Number(1.) - reference_point[0] - reference_point[1] -
                 reference_point[2]}};
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

    /// A reference point nearby whose face distances are at least `margin`.
    static Point<dim>
    clamp(const Point<dim> &reference_point, const double margin)
    {
      Point<dim> result;
      double     room = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        {
          result[d] = std::max(reference_point[d], margin);
          room += result[d] - margin;
        }
      const double excess = room + dim * margin - (1. - margin);
      if (excess > 0.)
        for (unsigned int d = 0; d < dim; ++d)
          result[d] -= excess / room * (result[d] - margin);
      return result;
    }

  private:
    Point<dim>                    origin;
    std::array<Tensor<1, dim>, 3> gradients; ///< of nodes 1 to 3, in 1/m
    double                        determinant;
  };
} // namespace Sandglass

#endif
