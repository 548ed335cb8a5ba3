#ifndef sandglass_material_largest_tension_h
#define sandglass_material_largest_tension_h

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  /**
   * The cut-off of tension -p of a cohesive material, in Pa: c cot(phi), which
   * is the apex of Mohr and Coulomb's pyramid, but no more than 2 c. That is
   * the unconfined compressive strength without friction, where the pyramid has
   * no apex.
   *
   * @param friction_angle  phi in rad.
   * @param cohesion        c in Pa.
   */
  inline double
  largest_tension(const double friction_angle, const double cohesion)
  {
    const double tangent = std::tan(friction_angle);
    return cohesion == 0. ? 0. : cohesion / std::max(tangent, 0.5);
  }
} // namespace Sandglass

#endif
