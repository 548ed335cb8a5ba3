#include <sandglass/observers/silo_measures.h>

#include <algorithm>
#include <limits>

namespace Sandglass
{
  namespace
  {
    /// Extent of the edges of one role; empty if there are none.
    struct Extent
    {
      Extent(const Mesh &mesh, const BoundaryRole role)
      {
        for (const auto &edge : mesh.edges)
          if (edge.role == role)
            for (const unsigned int vertex : edge.vertices)
              for (unsigned int d = 0; d < dim; ++d)
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

      Point<dim> lower{infinity, infinity}, upper{-infinity, -infinity};
    };



    /// Width of the whole silo between such edges.
    double
    whole_width(const Extent &extent, const bool has_axis)
    {
      if (extent.is_empty())
        return 0.;
      return has_axis ? 2. * extent.upper[0] :
                        extent.upper[0] - extent.lower[0];
    }
  } // namespace



  SiloMeasures::SiloMeasures(const Scene &scene)
    : has_open_outlet(
        std::any_of(scene.mesh.edges.begin(),
                    scene.mesh.edges.end(),
                    [](const Mesh::Edge &edge) { return is_open(edge.role); }))
  {
    const Extent outlet(scene.mesh, BoundaryRole::outlet);
    const Extent wall(scene.mesh, BoundaryRole::wall);
    const bool   has_axis = !Extent(scene.mesh, BoundaryRole::axis).is_empty();

    outlet_width = whole_width(outlet, has_axis);
    wall_width   = whole_width(wall, has_axis);
    wall_foot    = wall.lower[1];

    const double middle =
      has_axis || wall.is_empty() ? 0. : (wall.lower[0] + wall.upper[0]) / 2.;
    bottom_centre = Point<dim>(middle, scene.fill_bottom);
  }
} // namespace Sandglass
