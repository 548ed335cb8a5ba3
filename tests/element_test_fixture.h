#ifndef sandglass_tests_element_test_fixture_h
#define sandglass_tests_element_test_fixture_h

#include <sandglass/element_test/element_test.h>
#include <sandglass/material/matsuoka_nakai.h>

#include <gtest/gtest.h>

#include <vector>

/// What the tests of the element tests' driver share.
namespace ElementTestFixture
{
  using namespace Sandglass;

  constexpr double pi = 3.14159265358979323846;

  inline MaterialConstants
  constants_of(const YieldCone cone,
               const double    friction_angle,
               const double    cohesion = 0.)
  {
    MaterialConstants constants;
    constants.young_modulus           = 1e8;
    constants.yield_cone              = cone;
    constants.internal_friction_angle = friction_angle;
    constants.cohesion                = cohesion;
    return constants;
  }

  inline ElementTestSettings
  settings_of(const ElementTestKind kind, const double axial_strain)
  {
    ElementTestSettings settings;
    settings.kind         = kind;
    settings.axial_strain = axial_strain;
    return settings;
  }

  template <typename Law>
  std::vector<ElementTestRow>
  rows_of(
    const MaterialConstants   &constants,
    const ElementTestSettings &settings,
    const StressIntegration    integration = StressIntegration::middle_of_step)
  {
    const Law                   law(constants);
    std::vector<ElementTestRow> rows;
    ElementTest<Law>(law, constants, settings, integration)
      .run([&rows](const ElementTestRow &row) { rows.push_back(row); });
    return rows;
  }

  /// Of a strong material: its elasticity.
  inline MaterialConstants
  elastic()
  {
    return constants_of(YieldCone::compression, 30., 1e9);
  }

  /// The logarithm of the ratio of the volumes of two rows.
  inline double
  volume_change(const ElementTestRow &before, const ElementTestRow &after)
  {
    return std::abs(std::log((1. - after.volumetric_strain) /
                             (1. - before.volumetric_strain)));
  }
} // namespace ElementTestFixture

#endif
