#include <sandglass/output/flow_profile.h>
#include <sandglass/output/section_outline.h>
#include <sandglass/output/silo_measures.h>

#include <cmath>

namespace Sandglass
{
  namespace
  {
    constexpr unsigned int n_bands = 32;

    /// Of the silo's largest width, and of that at the band's own height.
    constexpr double reach_of_silo = 1. / 20., reach_of_band = 1. / 4.;

    /// Where the material is at a height.
    Range
    extent_at(const Mesh<2> &mesh, const double y)
    {
      Range              extent;
      const unsigned int n = mesh.vertices_per_cell();
      for (const auto &cell : mesh.cells)
        if (cell.is_filled)
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < i; ++j)
              {
                const Point<2> &a = mesh.vertices[cell.vertices[i]];
                const Point<2> &b = mesh.vertices[cell.vertices[j]];
                if ((a[1] <= y) != (b[1] <= y))
                  extent.add(a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]));
              }
      return extent;
    }



    /// x of the axis; NaN without one.
    double
    axis_of(const Mesh<2> &mesh)
    {
      for (const auto &edge : mesh.faces)
        if (edge.role == BoundaryRole::axis)
          return mesh.vertices[edge.vertices[0]][0];
      return std::numeric_limits<double>::quiet_NaN();
    }
  } // namespace



  template <>
  std::vector<FlowBand>
  flow_bands<2>(const Scene<2> &scene)
  {
    const SiloMeasures<2> measures(scene);
    std::vector<FlowBand> bands;
    if (!measures.has_open_outlet)
      return bands;

    const double axis   = axis_of(scene.mesh);
    const double height = (scene.fill_top - scene.fill_bottom) / n_bands;
    double       width  = 0.;
    for (unsigned int i = 0; i < n_bands; ++i)
      {
        const double lower   = scene.fill_bottom + i * height;
        const Range  extent  = extent_at(scene.mesh, lower + height / 2.);
        const auto   wall_at = [&](const double x) {
          return std::abs(x - axis) <= small_sine * extent.length() ?
                     std::numeric_limits<double>::quiet_NaN() :
                     x;
        };
        width = std::max(width, extent.length() * (std::isnan(axis) ? 1. : 2.));
        bands.push_back({lower,
                         lower + height,
                         measures.bottom_centre[0],
                         {{wall_at(extent.lower), wall_at(extent.upper)}},
                         reach_of_band * extent.length()});
      }
    for (FlowBand &band : bands)
      band.reach = std::min(band.reach, reach_of_silo * width);
    return bands;
  }
} // namespace Sandglass
