#include <sandglass/output/beverloo.h>
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
    whole_width(const Extent &extent, const Extent &axis)
    {
      if (extent.is_empty())
        return 0.;
      return axis.is_empty() ? extent.upper[0] - extent.lower[0] :
                               2. * std::max(extent.upper[0] - axis.middle(),
                                             axis.middle() - extent.lower[0]);
    }
  } // namespace



  template <>
  SiloMeasures<2>::SiloMeasures(const Scene<2> &scene)
    : has_open_outlet(std::any_of(scene.mesh.faces.begin(),
                                  scene.mesh.faces.end(),
                                  [](const Mesh<2>::Face &edge) {
                                    return is_open(edge.role);
                                  }))
    , has_slot(scene.formulation == Formulation::plane_strain)
  {
    const Extent outlet(scene.mesh, BoundaryRole::outlet);
    const Extent wall(scene.mesh, BoundaryRole::wall);
    const Extent axis(scene.mesh, BoundaryRole::axis);

    outlet_width  = whole_width(outlet, axis);
    bottom_centre = Point<2>(0., scene.fill_bottom);
    for (const Extent *extent : {&axis, &outlet, &wall})
      if (!extent->is_empty())
        {
          bottom_centre[0] = extent->middle();
          break;
        }
  }



  template <>
  double
  SiloMeasures<2>::beverloo_flow_rate(const double density,
                                      const double gravity,
                                      const double grain_size) const
  {
    return Sandglass::beverloo_flow_rate(has_slot ? Formulation::plane_strain :
                                                    Formulation::axisymmetric,
                                         density,
                                         gravity,
                                         outlet_width,
                                         grain_size);
  }
} // namespace Sandglass
