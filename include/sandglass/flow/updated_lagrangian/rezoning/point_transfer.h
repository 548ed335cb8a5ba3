#ifndef sandglass_flow_updated_lagrangian_rezoning_point_transfer_h
#define sandglass_flow_updated_lagrangian_rezoning_point_transfer_h

#include <deal.II/base/quadrature.h>

#include <sandglass/flow/updated_lagrangian/rezoning/field.h>
#include <sandglass/flow/updated_lagrangian/rezoning/patch_recovery.h>
#include <sandglass/flow/updated_lagrangian/rezoning/point_locator.h>

#include <functional>
#include <vector>

namespace Sandglass
{
  /// Whether a point may have these values; the values that it may have must
  /// form a convex set.
  using Admissible = std::function<bool(const double *values)>;

  /// Where a new mesh's quadrature points lie in the old one, each in the body
  /// of the same number.
  std::vector<Location>
  locate_points(const PointLocator  &locator,
                const TriangleMesh  &new_mesh,
                const Quadrature<2> &quadrature);

  /// A field at new quadrature points.
  struct TransferredPoints
  {
    MeshField    field;
    unsigned int n_limited = 0; ///< points whose values had to be limited
  };

  /**
   * Values of a recovered field at the new points.
   *
   * Where they are not admissible, they are moved towards the mean of the old
   * cell's values, as little as suffices.
   *
   * @param is_admissible  may be empty: then all values are.
   */
  TransferredPoints
  transfer_point_field(const PatchRecovery         &recovery,
                       const unsigned int           n_components,
                       const std::vector<Location> &locations,
                       const Admissible            &is_admissible);
} // namespace Sandglass

#endif
