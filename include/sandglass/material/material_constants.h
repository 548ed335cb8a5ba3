#ifndef sandglass_material_material_constants_h
#define sandglass_material_material_constants_h

#include <map>
#include <string>
#include <vector>

namespace Sandglass
{
  /// Which friction angle a cone of the invariants' space stands for.
  enum class YieldCone
  {
    matsuoka_nakai, ///< phi acts in triaxial compression and in extension
    plane_strain,   ///< phi acts in plane flow
    compression,    ///< phi acts in triaxial compression
    paper           ///< the mean of compression and extension
  };

  /// How stress turns with the material.
  enum class StressRate
  {
    jaumann,
    green_naghdi
  };

  /// What laws are made from, in the units in which users give it.
  struct MaterialConstants
  {
    std::string model = "Drucker-Prager"; ///< the law's name

    double    density                 = 1500.; ///< unstressed, in kg/m^3
    double    young_modulus           = 1e6;   ///< in Pa
    double    poisson_ratio           = 0.3;
    double    internal_friction_angle = 25.; ///< in degrees
    YieldCone yield_cone              = YieldCone::matsuoka_nakai;
    double    cohesion                = 0.;  ///< in Pa
    double    void_ratio              = 0.8; ///< unstressed, of laws with one

    StressRate stress_rate = StressRate::jaumann;

    /// Those that the user gave, by name; see law_constant().
    std::map<std::string, double> law_constants;

    /// Of the law UMAT: the shared library's path, the constants that it gets,
    /// and how many state variables it keeps.
    std::string         umat_library;
    std::vector<double> umat_constants;
    unsigned int        n_umat_state_variables = 0;
  };

  inline double
  radians(const double degrees)
  {
    return degrees * 3.14159265358979323846 / 180.;
  }

  /// The angle of internal friction in rad.
  inline double
  friction_angle(const MaterialConstants &constants)
  {
    return radians(constants.internal_friction_angle);
  }
} // namespace Sandglass

#endif
