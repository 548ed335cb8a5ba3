#ifndef sandglass_element_test_element_test_settings_h
#define sandglass_element_test_element_test_settings_h

#include <array>
#include <cmath>

namespace Sandglass
{
  /// Which strains of a material point are driven, and which stresses held.
  enum class ElementTestKind
  {
    oedometer,   ///< no lateral strain
    triaxial,    ///< both lateral stresses held
    biaxial,     ///< one lateral stress held, no strain out of the plane
    simple_shear ///< axial stress held, no lateral strain
  };

  /**
   * A test of a law at one material point. In all of them y is the axis, x the
   * lateral direction, z out of the plane.
   */
  struct ElementTestSettings
  {
    ElementTestKind kind = ElementTestKind::oedometer;

    /// Axial, lateral, and out of the plane; in Pa, compression positive.
    std::array<double, 3> initial_stress = {{1e5, 1e5, 1e5}};

    /// Change of length over initial length, compression positive; in simple
    /// shear the shear displacement over the initial height.
    double axial_strain = 0.2;

    double       largest_axial_stress = 0.;   ///< in Pa; 0: none
    unsigned int n_steps              = 1000; ///< to axial_strain
    double       strain_rate          = 0.01; ///< of axial_strain, in 1/s

    bool
    is_shear() const
    {
      return kind == ElementTestKind::simple_shear;
    }

    /// What a step takes, in s.
    double
    time_step() const
    {
      return std::abs(axial_strain) / (n_steps * strain_rate);
    }
  };
} // namespace Sandglass

#endif
