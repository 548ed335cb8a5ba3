// The element tests' driver: where a test ends, large steps, and what it does
// where there is no equilibrium.

#include "../element_test_fixture.h"

using namespace Sandglass;
using namespace ElementTestFixture;



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
