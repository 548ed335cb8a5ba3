#ifndef sandglass_particles_cell_moments_h
#define sandglass_particles_cell_moments_h

#include <sandglass/particles/cell_shape.h>

#include <vector>

namespace Sandglass
{
  /// Volume and middle of the particles that fill a cell at the start.
  template <int dim>
  struct CellMoments
  {
    double volume; ///< in m^3; plane strain: per metre of depth
    std::array<double, dim> mean_point; ///< reference coordinates, weighted
                                        ///< with volume
  };

  /// Area in m^2 (in space: volume in m^3) of one of n equal parts of a cell,
  /// from the part's centroid.
  template <typename Shape>
  double
  part_area(const Shape             &shape,
            const Point<Shape::dim> &centroid,
            const unsigned int       n)
  {
    return shape.jacobian(centroid) * Shape::reference_area / n;
  }

  /// Volume of such a part in m^3 (plane strain: per metre of depth,
  /// axisymmetric: of the whole ring).
  template <typename Kinematics, typename Shape>
  double
  part_volume(const Shape             &shape,
              const Point<Shape::dim> &centroid,
              const unsigned int       n)
  {
    return Kinematics::measure(shape.to_real(centroid)) *
           part_area(shape, centroid, n);
  }

  /// @param points  of the particles, see seed_points().
  template <typename Kinematics, typename Shape>
  CellMoments<Shape::dim>
  cell_moments(const Shape &shape, const std::vector<Point<Shape::dim>> &points)
  {
    CellMoments<Shape::dim> moments{};
    for (const auto &point : points)
      {
        const double volume =
          part_volume<Kinematics>(shape, point, points.size());
        moments.volume += volume;
        for (unsigned int d = 0; d < Shape::dim; ++d)
          moments.mean_point[d] += volume * point[d];
      }
    for (double &coordinate : moments.mean_point)
      coordinate /= moments.volume;
    return moments;
  }
} // namespace Sandglass

#endif
