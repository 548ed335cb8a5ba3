#ifndef sandglass_output_residence_raster_h
#define sandglass_output_residence_raster_h

#include <deal.II/base/point.h>

#include <sandglass/output/particle_fields.h>
#include <sandglass/output/vtu_file.h>
#include <sandglass/scene/scene.h>

#include <array>
#include <limits>
#include <vector>

namespace Sandglass
{
  /**
   * Rectangular cells that cover the initial material, all of one size: four
   * rows to a layer, and about as wide as they are high. In the plane the third
   * direction has one cell without thickness.
   */
  class ResidenceRaster
  {
  public:
    static constexpr unsigned int rows_per_layer = 4;
    static constexpr std::size_t  nowhere =
      std::numeric_limits<std::size_t>::max();

    template <int dim>
    explicit ResidenceRaster(const Scene<dim> &scene);

    std::size_t
    n_cells() const
    {
      return std::size_t(n[0]) * n[1] * n[2];
    }

    /// Corners of a cell, in how many dimensions.
    unsigned int
    points_per_cell() const
    {
      return n_dimensions == 2 ? 4 : 8;
    }
    unsigned int
    dimension() const
    {
      return n_dimensions;
    }

    /// The cell of a first place of material, or `nowhere`.
    std::size_t
    cell(const Point<3> &initial_location) const;

    /// The cell above one; `nowhere` above the highest row.
    std::size_t
    above(const std::size_t cell) const;

    /// As Layers::of().
    unsigned int
    layer(const std::size_t cell) const;

    /// Add a cell's corners and itself.
    void
    draw(const std::size_t cell, VtuPiece &piece) const;

  private:
    unsigned int
    row(const std::size_t cell) const
    {
      return cell / n[0] % n[1];
    }

    unsigned int                n_dimensions;
    Point<3>                    origin; ///< in m
    std::array<unsigned int, 3> n;
    std::array<double, 3>       size; ///< of a cell, in m
  };
} // namespace Sandglass

#endif
