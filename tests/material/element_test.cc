// The element tests' driver: closed forms of elasticity, of perfect plasticity
// and of mu(I).

#include <sandglass/material/mu_i.h>

#include "../element_test_fixture.h"
#include "../void_ratio_law.h"

using namespace Sandglass;
using namespace ElementTestFixture;



TEST(ElementTest, oedometer_has_the_confined_modulus)
{
  const auto constants    = elastic();
  auto       settings     = settings_of(ElementTestKind::oedometer, 0.1);
  settings.initial_stress = {{0., 0., 0.}};
  const auto       rows   = rows_of<DruckerPrager>(constants, settings);
  const Elasticity elasticity(constants.young_modulus, constants.poisson_ratio);
  ASSERT_EQ(rows.size(), 1001u);
  EXPECT_EQ(rows.front().axial_stress, 0.);
  EXPECT_EQ(rows.back().axial_strain, 0.1);
  EXPECT_NEAR(rows.back().volumetric_strain, 0.1, 1e-12);
  // The law gets true strains, here to second order in the step.
  const double stress = -elasticity.confined_modulus() * std::log(0.9);
  EXPECT_NEAR(rows.back().axial_stress / stress, 1., 1e-6);
  EXPECT_NEAR(rows.back().lateral_stress / rows.back().axial_stress,
              constants.poisson_ratio / (1. - constants.poisson_ratio),
              1e-12);
  EXPECT_TRUE(std::isnan(rows.back().void_ratio));
}



TEST(ElementTest, triaxial_has_youngs_modulus_and_poisson_ratio)
{
  const auto constants = elastic();
  for (const double strain : {0.01, -0.01})
    {
      auto settings           = settings_of(ElementTestKind::triaxial, strain);
      settings.initial_stress = {{1e5, 1e5, 2e5}};
      const auto   last = rows_of<DruckerPrager>(constants, settings).back();
      const double true_strain = std::log(1. - strain);
      EXPECT_NEAR((last.axial_stress - 1e5) /
                    (-constants.young_modulus * true_strain),
                  1.,
                  1e-5);
      EXPECT_NEAR(std::log(1. - last.volumetric_strain) / true_strain,
                  1. - 2. * constants.poisson_ratio,
                  1e-5);
      EXPECT_NEAR(last.lateral_stress, 1e5, 1e-3);
      EXPECT_NEAR(last.out_of_plane_stress, 2e5, 2e-3);
    }
}



TEST(ElementTest, triaxial_fails_where_mohr_and_coulomb_do)
{
  constexpr double angle = 35.;
  const double     sine  = std::sin(angle * pi / 180.);
  const double     ratio = (1. + sine) / (1. - sine);

  auto       settings = settings_of(ElementTestKind::triaxial, 0.1);
  const auto compression =
    rows_of<DruckerPrager>(constants_of(YieldCone::compression, angle),
                           settings);
  EXPECT_NEAR(compression.back().axial_stress / 1e5, ratio, 1e-6);
  const auto smooth = constants_of(YieldCone::matsuoka_nakai, angle);
  EXPECT_NEAR(rows_of<MatsuokaNakai>(smooth, settings).back().axial_stress /
                1e5,
              ratio,
              1e-6);
  // Plastic flow keeps the volume.
  EXPECT_LT(volume_change(compression[900], compression.back()), 1e-7);

  settings.axial_strain = -0.1;
  const auto extension  = rows_of<MatsuokaNakai>(smooth, settings).back();
  EXPECT_NEAR(extension.axial_stress / 1e5, 1. / ratio, 1e-6);
  EXPECT_NEAR(extension.lateral_stress / 1e5, 1., 1e-8);
  EXPECT_NEAR(extension.mobilised_friction_angle(), angle, 1e-4);
}



TEST(ElementTest, biaxial_has_the_typed_angle_in_plane_strain)
{
  for (const double angle : {20., 30., 40.})
    {
      const auto rows =
        rows_of<DruckerPrager>(constants_of(YieldCone::plane_strain, angle),
                               settings_of(ElementTestKind::biaxial, 0.2));
      const ElementTestRow &last = rows.back();
      EXPECT_NEAR(last.mobilised_friction_angle(), angle, 0.1);
      EXPECT_NEAR(last.lateral_stress / 1e5, 1., 1e-8);
      EXPECT_LT(volume_change(rows[900], last), 1e-5);
    }
}



TEST(ElementTest, unconfined_strength_is_that_of_cohesion)
{
  constexpr double cohesion = 5e3, angle = 30. * pi / 180.;
  const double     strength =
    2. * cohesion * std::cos(angle) / (1. - std::sin(angle));
  auto settings           = settings_of(ElementTestKind::triaxial, 0.05);
  settings.initial_stress = {{0., 0., 0.}};
  const auto constants = constants_of(YieldCone::matsuoka_nakai, 30., cohesion);
  const auto last      = rows_of<MatsuokaNakai>(constants, settings).back();
  EXPECT_NEAR(last.axial_stress / strength, 1., 1e-6);
  EXPECT_NEAR(last.lateral_stress / strength, 0., 1e-7);
}



TEST(ElementTest, simple_shear_is_elastic_then_plastic)
{
  const auto   constants = constants_of(YieldCone::plane_strain, 30.);
  const double modulus =
    Elasticity(constants.young_modulus, constants.poisson_ratio).shear_modulus;
  for (const double sign : {1., -1.})
    {
      const auto rows = rows_of<DruckerPrager>(
        constants, settings_of(ElementTestKind::simple_shear, sign * 0.2));
      // Of the pressure of 1e5 Pa, a shear strain of 2e-4 needs less than a
      // tenth.
      EXPECT_NEAR(rows[1].shear_stress / (sign * modulus * 2e-4), 1., 1e-3);
      EXPECT_NEAR(rows[1].shear_strain, sign * 2e-4, 1e-15);
      // Steady: s_xx = s_yy but for the turning of the stress, of the order of
      // tau / G.
      EXPECT_NEAR(rows.back().shear_stress / (sign * 1e5 * 0.5), 1., 2e-3);
      EXPECT_NEAR(rows.back().axial_stress / 1e5, 1., 1e-8);
      EXPECT_LT(volume_change(rows[900], rows.back()), 1e-5);
    }
}



// Elastic shear at constant height with Jaumann's rate (dienes1979): s_xy = G
// sin(gamma), s_xx = -s_yy = G (1 - cos(gamma)).
TEST(ElementTest, stress_turns_by_jaumanns_rate)
{
  const DruckerPrager law(elastic());
  const double        modulus = law.elasticity.shear_modulus;
  for (const auto &[integration, tolerance] :
       {std::pair(StressIntegration::middle_of_step, 1e-6),
        std::pair(StressIntegration::start_of_step, 5e-3)})
    {
      MaterialPoint<DruckerPrager> point;
      point.stress.setZero();
      UniformGradient gradient;
      gradient.shear = 2e-3;
      for (unsigned int n = 0; n < 1000; ++n)
        point = deformed(point, gradient, law, integration, 1.);
      EXPECT_NEAR(point.shear, 2., 1e-12);
      EXPECT_NEAR(point.volumetric_strain(), 0., 1e-12);
      EXPECT_NEAR(point.stress[3] / modulus, std::sin(2.), tolerance);
      EXPECT_NEAR(point.stress[0] / modulus, 1. - std::cos(2.), tolerance);
      EXPECT_NEAR(point.stress[1] / modulus, std::cos(2.) - 1., tolerance);
    }
}



TEST(ElementTest, friction_of_mu_i_grows_with_the_rate)
{
  auto constants               = constants_of(YieldCone::paper, 20.9);
  constants.model              = MuI::name;
  constants.law_constants["d"] = 1e-2;
  auto settings           = settings_of(ElementTestKind::simple_shear, 0.5);
  settings.initial_stress = {{1e3, 1e3, 1e3}};
  double last_friction    = 0.;
  for (const double rate : {1e-3, 10., 100.})
    {
      settings.strain_rate         = rate;
      const auto   last            = rows_of<MuI>(constants, settings).back();
      const double mu              = last.shear_stress / last.axial_stress;
      const double inertial_number = rate * 1e-2 * std::sqrt(2500. / 1e3);
      const double slow            = std::tan(20.9 * pi / 180.);
      const double fast            = std::tan(32.76 * pi / 180.);
      EXPECT_NEAR(mu,
                  slow + (fast - slow) / (1. + 0.278 / inertial_number),
                  1e-3);
      EXPECT_GT(mu, last_friction);
      last_friction = mu;
    }
}



TEST(ElementTest, void_ratio_follows_the_volume)
{
  MaterialConstants constants = constants_of(YieldCone::paper, 30.);
  for (const auto kind :
       {ElementTestKind::oedometer, ElementTestKind::triaxial})
    for (const ElementTestRow &row :
         rows_of<VoidRatioLaw>(constants, settings_of(kind, 0.1)))
      EXPECT_NEAR((1. + row.void_ratio) / 1.8,
                  1. - row.volumetric_strain,
                  1e-5);
}
