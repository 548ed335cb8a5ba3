#ifndef sandglass_material_material_constants_h
#define sandglass_material_material_constants_h

namespace Sandglass
{
  /// What laws are made from, in the units in which users give it.
  struct MaterialConstants
  {
    double density                 = 1500.; ///< unstressed, in kg/m^3
    double young_modulus           = 1e6;   ///< in Pa
    double poisson_ratio           = 0.3;
    double internal_friction_angle = 25.; ///< in degrees
  };
} // namespace Sandglass

#endif
