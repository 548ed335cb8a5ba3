#include <sandglass/output/silo_measures.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Sandglass
{
  namespace
  {
    /// Extent of the edges of one role; empty if there are none.
    struct Extent
    {
      Extent(const Mesh<2> &mesh, const BoundaryRole role)
      {
        for (const auto &edge : mesh.faces)
          if (edge.role == role)
            for (const unsigned int vertex : edge.vertices)
              for (unsigned int d = 0; d < 2; ++d)
                {
                  lower[d] = std::min(lower[d], mesh.vertices[vertex][d]);
                  upper[d] = std::max(upper[d], mesh.vertices[vertex][d]);
                }
      }

      bool
      is_empty() const
      {
        return lower[0] > upper[0];
      }

      static constexpr double infinity =
        std::numeric_limits<double>::infinity();

      double
      middle() const
      {
        return (lower[0] + upper[0]) / 2.;
      }

      Point<2> lower{infinity, infinity}, upper{-infinity, -infinity};
    };



    /// Width of the whole silo between such edges.
    double
    whole_width(const Extent &extent, const bool has_axis)
    {
      if (extent.is_empty())
        return 0.;
      // The axis is at x = 0, at either end of the section.
      return has_axis ? 2. * std::max(extent.upper[0], -extent.lower[0]) :
                        extent.upper[0] - extent.lower[0];
    }



    /// |dx / dy| of the hopper's edges, or NaN where they differ.
    double
    common_slope(const Mesh<2> &mesh)
    {
      double slope = std::numeric_limits<double>::quiet_NaN();
      for (const auto &edge : mesh.faces)
        if (edge.role == BoundaryRole::hopper)
          {
            const Tensor<1, 2> along =
              mesh.vertices[edge.vertices[1]] - mesh.vertices[edge.vertices[0]];
            const double of_edge = std::abs(along[0] / along[1]);
            if (std::isnan(slope))
              slope = of_edge;
            if (!(std::abs(of_edge - slope) <= 1e-6 * slope))
              return std::numeric_limits<double>::quiet_NaN();
          }
      return slope;
    }
  } // namespace



  template <>
  SiloMeasures<2>::SiloMeasures(const Scene<2> &scene)
    : has_open_outlet(std::any_of(scene.mesh.faces.begin(),
                                  scene.mesh.faces.end(),
                                  [](const Mesh<2>::Face &edge) {
                                    return is_open(edge.role);
                                  }))
  {
    const Extent outlet(scene.mesh, BoundaryRole::outlet);
    const Extent wall(scene.mesh, BoundaryRole::wall);
    const Extent hopper(scene.mesh, BoundaryRole::hopper);
    const bool   has_axis = !Extent(scene.mesh, BoundaryRole::axis).is_empty();

    outlet_width = whole_width(outlet, has_axis);
    wall_width   = whole_width(wall, has_axis);
    wall_foot    = wall.lower[1];

    const bool is_below_wall =
      !hopper.is_empty() && !wall.is_empty() &&
      std::abs(hopper.upper[1] - wall_foot) < 1e-6 * wall_width &&
      std::abs(whole_width(hopper, has_axis) - wall_width) < 1e-6 * wall_width;
    hopper_slope = is_below_wall ? common_slope(scene.mesh) :
                                   std::numeric_limits<double>::quiet_NaN();

    bottom_centre       = Point<2>(0., scene.fill_bottom);
    outlet_eccentricity = 0.;
    if (has_axis)
      return;
    if (!outlet.is_empty())
      bottom_centre[0] = outlet.middle();
    else if (!wall.is_empty())
      bottom_centre[0] = wall.middle();
    if (!outlet.is_empty() && !wall.is_empty())
      outlet_eccentricity = std::abs(outlet.middle() - wall.middle());
  }
} // namespace Sandglass
