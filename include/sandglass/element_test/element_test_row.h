#ifndef sandglass_element_test_element_test_row_h
#define sandglass_element_test_element_test_row_h

#include <algorithm>
#include <cmath>
#include <limits>

namespace Sandglass
{
  /// What a row of element_test.csv is read from: strains as shares of initial
  /// lengths and volume, stresses in Pa, compression positive.
  struct ElementTestRow
  {
    double axial_strain = 0., volumetric_strain = 0.;
    double shear_strain = 0.; ///< engineering's
    double axial_stress = 0., lateral_stress = 0., out_of_plane_stress = 0.;
    double shear_stress = 0.; ///< positive where it resists the shear strain
    double void_ratio   = std::numeric_limits<double>::quiet_NaN();

    /// q = sqrt(3/2 s : s) in Pa.
    double
    von_mises_stress() const
    {
      const auto squared = [](const double x) { return x * x; };
      return std::sqrt(0.5 * (squared(axial_stress - lateral_stress) +
                              squared(lateral_stress - out_of_plane_stress) +
                              squared(out_of_plane_stress - axial_stress)) +
                       3. * squared(shear_stress));
    }

    /// asin((s_1 - s_3) / (s_1 + s_3)) of the extreme principal stresses, in
    /// degrees; not a number without stress.
    double
    mobilised_friction_angle() const
    {
      const double mean = 0.5 * (axial_stress + lateral_stress);
      const double radius =
        std::hypot(0.5 * (axial_stress - lateral_stress), shear_stress);
      const double largest  = std::max(mean + radius, out_of_plane_stress);
      const double smallest = std::min(mean - radius, out_of_plane_stress);
      if (!(largest + smallest > 0.))
        return std::numeric_limits<double>::quiet_NaN();
      // Cohesion may bear tension.
      const double sine = (largest - smallest) / (largest + smallest);
      return std::asin(std::min(sine, 1.)) * 180. / 3.14159265358979323846;
    }
  };
} // namespace Sandglass

#endif
