#include <sandglass/choices/dimensions.h>
#include <sandglass/output/residence_raster.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  namespace
  {
    /// Fewest and most columns, whatever the silo's proportions.
    constexpr double fewest_columns = 8., most_columns = 128.;

    /// Rounding must not take material on the edge of a cell to another layer.
    constexpr double edge_share = 1e-6;
  } // namespace



  template <int dim>
  ResidenceRaster::ResidenceRaster(const Scene<dim> &scene)
    : n_dimensions(dim)
    , n{{1, 1, 1}}
    , size{{0., 0., 0.}}
  {
    Point<3> lower, upper;
    bool     is_first = true;
    for (const auto &cell : scene.mesh.cells)
      if (cell.is_filled)
        for (unsigned int v = 0; v < scene.mesh.vertices_per_cell(); ++v)
          for (unsigned int d = 0; d < dim; ++d)
            {
              const double x = scene.mesh.vertices[cell.vertices[v]][d];
              if (is_first || x < lower[d])
                lower[d] = x;
              if (is_first || x > upper[d])
                upper[d] = x;
              is_first = is_first && d + 1 < dim;
            }
    origin  = lower;
    n[1]    = rows_per_layer * Layers::n;
    size[1] = (upper[1] - lower[1]) / n[1];
    for (unsigned int d = 0; d < dim; d += 2)
      {
        const double length = upper[d] - lower[d];
        n[d]                = static_cast<unsigned int>(std::round(
          std::clamp(length / size[1], fewest_columns, most_columns)));
        size[d]             = length / n[d];
      }
  }



  std::size_t
  ResidenceRaster::cell(const Point<3> &initial_location) const
  {
    std::array<std::size_t, 3> index{{0, 0, 0}};
    for (unsigned int d = 0; d < n_dimensions; ++d)
      {
        double place = (initial_location[d] - origin[d]) / size[d];
        // Layers are counted from above.
        place += d == 1 ? -edge_share : edge_share;
        if (!(place > -1. && place < n[d] + 1.))
          return nowhere;
        index[d] = std::clamp<long>(std::floor(place), 0, n[d] - 1);
      }
    return (index[2] * n[1] + index[1]) * n[0] + index[0];
  }



  std::size_t
  ResidenceRaster::above(const std::size_t cell) const
  {
    return row(cell) + 1 < n[1] ? cell + n[0] : nowhere;
  }



  unsigned int
  ResidenceRaster::layer(const std::size_t cell) const
  {
    return Layers::n - row(cell) / rows_per_layer;
  }



  void
  ResidenceRaster::draw(const std::size_t cell, VtuPiece &piece) const
  {
    const std::array<std::size_t, 3> index{
      {cell % n[0], row(cell), cell / n[0] / n[1]}};
    for (unsigned int corner = 0; corner < piece.points_per_cell; ++corner)
      {
        // In VTK's order: round the lower face, then round the upper one.
        const std::array<unsigned int, 3> end{
          {(corner + 1) / 2 % 2, corner / 2 % 2, corner / 4}};
        piece.cells.push_back(piece.points.size() / 3);
        for (unsigned int d = 0; d < 3; ++d)
          piece.points.push_back(origin[d] + (index[d] + end[d]) * size[d]);
      }
  }



#define INSTANTIATE(dim) \
  template ResidenceRaster::ResidenceRaster(const Scene<dim> &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
