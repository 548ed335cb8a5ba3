// The element tests' driver: closed forms of elasticity and of perfect
// plasticity, and what it does where there is no equilibrium.

#include <sandglass/element_test/element_test.h>
#include <sandglass/material/matsuoka_nakai.h>
#include <sandglass/material/mu_i.h>

#include <gtest/gtest.h>

#include <vector>

#include "../void_ratio_law.h"

using namespace Sandglass;

namespace
{
  constexpr double pi = 3.14159265358979323846;

  MaterialConstants
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

  ElementTestSettings
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
  MaterialConstants
  elastic()
  {
    return constants_of(YieldCone::compression, 30., 1e9);
  }

  /// The logarithm of the ratio of the volumes of two rows.
  double
  volume_change(const ElementTestRow &before, const ElementTestRow &after)
  {
    return std::abs(std::log((1. - after.volumetric_strain) /
                             (1. - before.volumetric_strain)));
  }
} // namespace



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



TEST(ElementTest, ends_at_the_largest_axial_stress)
{
  auto settings                 = settings_of(ElementTestKind::oedometer, 0.2);
  settings.n_steps              = 20;
  settings.largest_axial_stress = 4e6;
  const auto constants          = constants_of(YieldCone::paper, 30.);
  const auto coarse             = rows_of<DruckerPrager>(constants, settings);
  EXPECT_LT(coarse.size(), 10u);
  EXPECT_NEAR(coarse.back().axial_stress / 4e6, 1., 1e-9);
  EXPECT_LT(coarse[coarse.size() - 2].axial_stress, 4e6);
}



// A step that is too large for an increment comes out by halving.
TEST(ElementTest, large_steps_give_the_same_strength)
{
  auto settings    = settings_of(ElementTestKind::triaxial, 0.95);
  settings.n_steps = 1;
  const auto last =
    rows_of<MatsuokaNakai>(constants_of(YieldCone::matsuoka_nakai, 40.),
                           settings)
      .back();
  EXPECT_EQ(last.axial_strain, 0.95);
  EXPECT_NEAR(last.mobilised_friction_angle(), 40., 1e-3);
}



namespace
{
  /// Drucker-Prager's law that loses count beyond a stress.
  class Failing : public DruckerPrager
  {
  public:
    using DruckerPrager::DruckerPrager;

    template <int n, typename Number, typename State, typename Prediction>
    Number
    correct(Eigen::Matrix<Number, n, 1> &stress,
            State                       &state,
            const Prediction            &prediction) const
    {
      const Number result = DruckerPrager::correct(stress, state, prediction);
      if (stress[1] < -3e5)
        throw std::runtime_error("too much");
      if (stress[1] < -2e5)
        stress[1] = std::nan("");
      return result;
    }
  };

  /// A cap that hardens: the pressure at most that of the state, and half of
  /// what is beyond raises it.
  class Cap : public DruckerPrager
  {
  public:
    static constexpr std::array<StateVariable, 1> state_variables = {
      {{"cap", "Pa", 1}}};

    using DruckerPrager::DruckerPrager;

    std::array<double, 1>
    initial_state() const
    {
      return {{10.}};
    }

    template <int n, typename Number, typename State, typename Prediction>
    Number
    correct(Eigen::Matrix<Number, n, 1> &stress,
            State                       &state,
            const Prediction            &prediction) const
    {
      const Number result = DruckerPrager::correct(stress, state, prediction);
      const Number excess = pressure(stress) - state[0];
      if (excess > 0.)
        {
          state[0] += 0.5 * excess;
          stress += isotropic<n>(0.5 * excess);
        }
      return result;
    }
  };

  /// The message with which the initial stress is refused.
  template <typename Law>
  std::string
  refusal(const MaterialConstants   &constants,
          const ElementTestSettings &settings)
  {
    try
      {
        rows_of<Law>(constants, settings);
      }
    catch (const InputError &error)
      {
        EXPECT_EQ(error.section, "Element test");
        EXPECT_EQ(error.name, "Initial stress");
        return error.what();
      }
    return "";
  }
} // namespace



TEST(ElementTest, keeps_the_rows_before_it_fails)
{
  const auto    constants = constants_of(YieldCone::compression, 40.);
  const Failing law(constants);
  for (const auto kind :
       {ElementTestKind::oedometer, ElementTestKind::triaxial})
    {
      const auto                  settings = settings_of(kind, 0.1);
      std::vector<ElementTestRow> rows;
      const ElementTest<Failing>  test(law,
                                      constants,
                                      settings,
                                      StressIntegration::start_of_step);
      try
        {
          test.run([&rows](const ElementTestRow &row) { rows.push_back(row); });
          ADD_FAILURE() << "it came to its end";
        }
      catch (const RunError &error)
        {
          const std::string message = error.what();
          for (const std::string part : {"Drucker-Prager",
                                         "axial strain of 0.00",
                                         "no longer finite",
                                         "more Steps"})
            EXPECT_NE(message.find(part), std::string::npos) << message;
          EXPECT_NE(message.find("step " + std::to_string(rows.size()) + " of"),
                    std::string::npos)
            << message;
        }
      EXPECT_GT(rows.size(), 5u);
      EXPECT_LT(rows.back().axial_stress, 2e5);
      EXPECT_GT(rows.back().axial_stress, 1.8e5);
    }
}



TEST(ElementTest, hardens_up_to_the_initial_stress)
{
  auto       constants = constants_of(YieldCone::compression, 30.);
  const auto rows =
    rows_of<Cap>(constants, settings_of(ElementTestKind::triaxial, 0.01));
  EXPECT_EQ(rows.front().axial_stress, 1e5);
  // Nothing of the stress is lost when the test begins.
  EXPECT_GT(rows[1].axial_stress, 1e5);
}



TEST(ElementTest, refuses_initial_stress_beyond_strength)
{
  const auto sand         = constants_of(YieldCone::matsuoka_nakai, 30.);
  auto       settings     = settings_of(ElementTestKind::triaxial, 0.1);
  settings.initial_stress = {{3.1e5, 1e5, 1e5}};
  EXPECT_NE(refusal<MatsuokaNakai>(sand, settings).find("within its strength"),
            std::string::npos);
  settings.initial_stress = {{2.9e5, 1e5, 1e5}};
  EXPECT_EQ(refusal<MatsuokaNakai>(sand, settings), "");
  settings.initial_stress = {{0., 0., 0.}};
  EXPECT_NE(refusal<MatsuokaNakai>(sand, settings).find("greater than 0"),
            std::string::npos);
  settings.kind = ElementTestKind::oedometer;
  EXPECT_EQ(refusal<MatsuokaNakai>(sand, settings), "");
  // Where the law itself complains.
  settings.initial_stress = {{4e5, 4e5, 4e5}};
  EXPECT_NE(refusal<Failing>(sand, settings).find("too much"),
            std::string::npos);
}
