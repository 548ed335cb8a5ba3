#include <sandglass/flow/updated_lagrangian/rezoning/point_transfer.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_element.h>

namespace Sandglass
{
  namespace
  {
    /// Move values towards admissible ones, up to the last one of the
    /// admissible on the way.
    void
    make_admissible(double                    *values,
                    const std::vector<double> &mean,
                    const Admissible          &is_admissible)
    {
      const std::vector<double> recovered(values, values + mean.size());
      const auto                set_share = [&](const double share) {
        for (unsigned int c = 0; c < mean.size(); ++c)
          values[c] = mean[c] + share * (recovered[c] - mean[c]);
        return is_admissible(values);
      };
      double share_inside = 0., share_outside = 1.;
      for (unsigned int i = 0; i < 40; ++i)
        {
          const double middle = (share_inside + share_outside) / 2.;
          (set_share(middle) ? share_inside : share_outside) = middle;
        }
      set_share(share_inside);
    }
  } // namespace



  std::vector<Location>
  locate_points(const PointLocator  &locator,
                const TriangleMesh  &new_mesh,
                const Quadrature<2> &quadrature)
  {
    std::vector<Location> locations;
    for (const Point<2> &p : quadrature_positions(new_mesh, quadrature))
      locations.push_back(
        locator.find(p, new_mesh.bodies[locations.size() / quadrature.size()]));
    return locations;
  }



  TransferredPoints
  transfer_point_field(const PatchRecovery         &recovery,
                       const unsigned int           n_components,
                       const std::vector<Location> &locations,
                       const Admissible            &is_admissible)
  {
    TransferredPoints result;
    result.field = MeshField::zero(n_components, locations.size());
    for (std::size_t i = 0; i < locations.size(); ++i)
      {
        double *values     = result.field.at(i);
        bool    is_limited = recovery.evaluate(locations[i], values);
        if (is_admissible && !is_admissible(values))
          {
            is_limited = true;
            make_admissible(values,
                            recovery.mean_in(locations[i].cell),
                            is_admissible);
          }
        result.n_limited += is_limited;
      }
    return result;
  }
} // namespace Sandglass
