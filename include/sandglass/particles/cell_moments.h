#ifndef sandglass_particles_cell_moments_h
#define sandglass_particles_cell_moments_h

#include <sandglass/particles/cell_shape.h>

#include <vector>

namespace Sandglass
{
  /// Of the particles that fill a cell at the start.
  struct CellMoments
  {
    double       volume;     ///< in m^3; plane strain: per metre of depth
    Pair<double> mean_point; ///< reference coordinates, weighted with volume
  };

  /// Area in m^2 of one of n equal parts of a cell, from the part's centroid.
  template <CellType cell_type>
  double
  part_area(const CellShape<cell_type> &shape,
            const Point<dim>           &centroid,
            const unsigned int          n)
  {
    return shape.jacobian(centroid) * CellShape<cell_type>::reference_area / n;
  }

  /// Volume of the same in m^3 (plane strain: per metre of depth, axisymmetric:
  /// of the whole ring).
  template <CellType cell_type>
  double
  part_volume(const CellShape<cell_type> &shape,
              const Formulation           formulation,
              const Point<dim>           &centroid,
              const unsigned int          n)
  {
    const double area = part_area(shape, centroid, n);
    return formulation == Formulation::plane_strain ?
             area :
             2. * numbers::PI * shape.to_real(centroid)[0] * area;
  }

  /// @param points  of the particles, see seed_points().
  template <CellType cell_type>
  CellMoments
  cell_moments(const CellShape<cell_type>    &shape,
               const Formulation              formulation,
               const std::vector<Point<dim>> &points)
  {
    CellMoments moments{};
    for (const Point<dim> &point : points)
      {
        const double volume =
          part_volume(shape, formulation, point, points.size());
        moments.volume += volume;
        for (unsigned int d = 0; d < dim; ++d)
          moments.mean_point[d] += volume * point[d];
      }
    for (double &coordinate : moments.mean_point)
      coordinate /= moments.volume;
    return moments;
  }
} // namespace Sandglass

#endif
