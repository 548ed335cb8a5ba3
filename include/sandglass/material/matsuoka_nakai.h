#ifndef sandglass_material_matsuoka_nakai_h
#define sandglass_material_matsuoka_nakai_h

#include <sandglass/material/drucker_prager.h>
#include <sandglass/material/matsuoka_nakai_cone.h>

namespace Sandglass
{
  /// As DruckerPrager, but within the cone of Matsuoka and Nakai (1974).
  class MatsuokaNakai : public IsochoricPlasticity<MatsuokaNakaiCone>
  {
  public:
    /// The parameter Material/Model knows the two by one name.
    static constexpr const char *name        = DruckerPrager::name;
    static constexpr const char *description = DruckerPrager::description;

    static bool
    is_meant(const MaterialConstants &constants)
    {
      return constants.model == name && !DruckerPrager::is_meant(constants);
    }

    explicit MatsuokaNakai(const MaterialConstants &constants)
      : IsochoricPlasticity(
          Elasticity(constants.young_modulus, constants.poisson_ratio),
          MatsuokaNakaiCone(friction_angle(constants), constants.cohesion),
          largest_tension(friction_angle(constants), constants.cohesion))
    {}
  };
} // namespace Sandglass

#endif
