#ifndef sandglass_material_drucker_prager_h
#define sandglass_material_drucker_prager_h

#include <sandglass/material/circular_cone.h>
#include <sandglass/material/isochoric_plasticity.h>
#include <sandglass/material/largest_tension.h>

namespace Sandglass
{
  /**
   * Drucker-Prager plasticity, f = q - m p, less a strength of the cohesion,
   * with incompressible plastic flow (paper, Sections 2.2 and 4.1).
   */
  class DruckerPrager : public IsochoricPlasticity<CircularCone>
  {
  public:
    /// Value of the parameter Material/Model.
    static constexpr char name[] = "Drucker-Prager";
    /// For the documentation of that parameter.
    static constexpr char description[] =
      "linear elasticity within the cone that `Yield cone` names, and "
      "incompressible plastic flow (Drucker-Prager)";

    /// Whether the parameters ask for this law.
    static bool
    is_meant(const MaterialConstants &constants)
    {
      // Without friction Matsuoka and Nakai's cone is the cylinder, too.
      return constants.model == name &&
             (constants.yield_cone != YieldCone::matsuoka_nakai ||
              constants.internal_friction_angle == 0.);
    }

    /// The paper's cone without cohesion.
    /// @param friction_angle  internal friction angle phi in rad.
    DruckerPrager(const Elasticity &elasticity, const double friction_angle)
      : IsochoricPlasticity(elasticity,
                            CircularCone(YieldCone::paper, friction_angle, 0.),
                            0.)
    {}

    explicit DruckerPrager(const MaterialConstants &constants)
      : IsochoricPlasticity(
          Elasticity(constants.young_modulus, constants.poisson_ratio),
          CircularCone(constants.yield_cone,
                       friction_angle(constants),
                       constants.cohesion),
          largest_tension(friction_angle(constants), constants.cohesion))
    {}
  };
} // namespace Sandglass

#endif
