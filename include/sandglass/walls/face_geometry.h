#ifndef sandglass_walls_face_geometry_h
#define sandglass_walls_face_geometry_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>

namespace Sandglass
{
  using namespace dealii;

  /// Unit normal of the line or plane through some points, to the right of the
  /// line or by the right-hand rule.
  template <int dim>
  Tensor<1, dim>
  unit_normal(const std::array<Point<dim>, dim> &points)
  {
    static_assert(dim == 2 || dim == 3);
    Tensor<1, dim> normal;
    if constexpr (dim == 2)
      normal = cross_product_2d(points[1] - points[0]);
    else
      normal = cross_product_3d(points[1] - points[0], points[2] - points[0]);
    return normal / normal.norm();
  }

  /// Outward unit normal of a boundary face of a cell; of a quadrilateral that
  /// isn't plane the mean one.
  template <typename CellIterator>
  auto
  outward_normal(const CellIterator &cell, const unsigned int face_no)
  {
    constexpr int               dim  = CellIterator::AccessorType::dimension;
    const auto                  face = cell->face(face_no);
    std::array<Point<dim>, dim> points;
    for (unsigned int v = 0; v < dim; ++v)
      points[v] = face->vertex(v);
    Tensor<1, dim> normal = unit_normal<dim>(points);
    if constexpr (dim == 3)
      if (face->n_vertices() == 4)
        {
          normal = cross_product_3d(face->vertex(3) - face->vertex(0),
                                    face->vertex(2) - face->vertex(1));
          normal /= normal.norm();
        }
    return normal * (face->center() - cell->center()) > 0. ? normal :
                                                             -1. * normal;
  }
} // namespace Sandglass

#endif
