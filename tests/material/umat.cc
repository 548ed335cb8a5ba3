// Laws from shared libraries: two of our own, one of them in Fortran.

#include <sandglass/continuum/in_plane_increment.h>
#include <sandglass/material/drucker_prager.h>
#include <sandglass/material/umat.h>

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>

#include "../random_engine.h"

using namespace Sandglass;

namespace Sandglass
{
  /// As a rotation in space has to be for a law that wants to know it.
  struct RotationInSpace
  {
    std::array<double, 9> entries;
  };

  std::array<double, 9>
  rotation_numbers(const RotationInSpace &rotation)
  {
    return rotation.entries;
  }
} // namespace Sandglass

namespace
{
  template <int n>
  struct Increment
  {
    SymmetricComponents<n> strain;
  };

  struct TurnedIncrement
  {
    SymmetricComponents<4>  strain;
    InPlaneRotation<double> rotation;
  };

  struct TurnedIncrementInSpace
  {
    SymmetricComponents<6> strain;
    RotationInSpace        rotation;
  };

  /// What umat_probe.c does.
  enum Probe
  {
    elastic,
    echo,
    ask_for_smaller_step,
    return_nan,
    call_xit,
    call_abqerr
  };

  MaterialConstants
  probe_constants(const Probe probe)
  {
    MaterialConstants constants;
    constants.model          = "UMAT";
    constants.umat_library   = SANDGLASS_UMAT_PROBE;
    constants.umat_constants = {double(probe), 1e4};
    return constants;
  }

  /// The message of what `function` throws; empty if it throws nothing.
  template <typename Exception>
  std::string
  message_of(const std::function<void()> &function)
  {
    try
      {
        function();
      }
    catch (const Exception &exception)
      {
        return exception.what();
      }
    return "";
  }

  std::string
  refusal_of(const MaterialConstants &constants)
  {
    return message_of<InputError>([&]() { Umat umat(constants); });
  }

  std::string
  failure_of(const Probe probe)
  {
    const Umat             umat(probe_constants(probe));
    SymmetricComponents<4> stress(-1e3, -2e3, -1.5e3, 900.);
    auto                   state = umat.initial_state();
    Increment<4>           increment;
    increment.strain << 1e-3, -2e-3, 5e-4, 1e-3;
    return message_of<LawFailure>(
      [&]() { umat.correct(stress, state, umat.predict(increment, 1e-4)); });
  }

  void
  expect_contains(const std::string &text, const std::string &part)
  {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\nin\n" << text;
  }

#ifdef SANDGLASS_UMAT_DRUCKER_PRAGER
  MaterialConstants
  drucker_prager_constants()
  {
    MaterialConstants constants;
    constants.model                  = "UMAT";
    constants.yield_cone             = YieldCone::paper;
    constants.umat_library           = SANDGLASS_UMAT_DRUCKER_PRAGER;
    constants.n_umat_state_variables = 1;
    constants.umat_constants         = {constants.young_modulus,
                                        constants.poisson_ratio,
                                        DruckerPrager(constants).cone.slope};
    return constants;
  }

  /// Random paths of both laws side by side, in all lanes.
  template <int n, typename Number>
  void
  compare_on_random_paths()
  {
    const MaterialConstants          constants = drucker_prager_constants();
    const Umat                       umat(constants);
    const DruckerPrager              built_in(constants);
    std::mt19937                     engine = random_engine();
    std::normal_distribution<double> normal;
    double                           n_yielded = 0.;
    for (unsigned int path = 0; path < 100; ++path)
      {
        SymmetricComponents<n, Number> stress = isotropic<n>(Number(-5e3));
        SymmetricComponents<n, Number> built_in_stress = stress;
        LawState<Umat, Number>         state;
        state.fill(Number(0.));
        std::array<Number, 0> none;
        for (unsigned int step = 0; step < 50; ++step)
          {
            Increment<n> increment;
            for (int c = 0; c < n; ++c)
              increment.strain[c] = 1e-3 * normal(engine);
            umat.correct(stress, state, umat.predict(increment, 1e-4));
            built_in.correct(built_in_stress,
                             none,
                             built_in.predict(increment, 1e-4));
            for (int c = 0; c < n; ++c)
              for (unsigned int lane = 0;
                   lane < sizeof(Number) / sizeof(double);
                   ++lane)
                ASSERT_NEAR(number_of_lane(stress[c], lane),
                            number_of_lane(built_in_stress[c], lane),
                            1e-12 * 1e5); // 1e5 Pa: the largest stress
          }
        n_yielded += number_of_lane(state[0], 0);
      }
    EXPECT_GT(n_yielded, 500.);
    EXPECT_LT(n_yielded, 5000.);
  }
#endif
} // namespace



#ifdef SANDGLASS_UMAT_DRUCKER_PRAGER
TEST(Umat, cone_in_fortran_is_that_of_the_built_in_law)
{
  compare_on_random_paths<4, double>();
  compare_on_random_paths<6, double>();
  compare_on_random_paths<4, Lanes>();
  compare_on_random_paths<6, Lanes>();
}



// DDSDDE is left alone there, so the tangent is one of differences.
TEST(Umat, tangent_by_differences_is_that_of_the_built_in_law)
{
  const MaterialConstants constants = drucker_prager_constants();
  const Umat              umat(constants);
  const DruckerPrager     built_in(constants);
  const auto              state = umat.initial_state();
  std::array<double, 0>   none;
  SymmetricComponents<6>  stress;
  stress << -1e3, -2e3, -1.5e3, 300., 200., -100.;
  Increment<6> increment;
  for (const double size : {1e-5, 1e-2}) // elastic, plastic
    for (const double elastic_share : {0., 0.3})
      {
        increment.strain << 1., -2., 0.5, 1., 0.3, -0.2;
        increment.strain *= size;
        const auto tangent =
          umat.tangent(stress, state, increment, elastic_share);
        const auto expected =
          built_in.tangent(stress, none, increment, elastic_share);
        EXPECT_LT((tangent.by_strain - expected.by_strain).norm(),
                  1e-5 * expected.by_strain.norm());
        EXPECT_LT((tangent.by_stress - expected.by_stress).norm(),
                  1e-5 * expected.by_stress.norm());
      }
}



TEST(Umat, wrong_numbers_of_constants_are_refused)
{
  MaterialConstants constants = drucker_prager_constants();
  constants.umat_constants.pop_back();
  expect_contains(refusal_of(constants), "'UMAT constants': 2 constants");
  expect_contains(refusal_of(constants), "needs 3");
  constants                        = drucker_prager_constants();
  constants.n_umat_state_variables = 4;
  expect_contains(refusal_of(constants), "'UMAT state variables': 4");
  expect_contains(refusal_of(constants), "needs 1");
}
#endif



// In the order of Abaqus, and with shear as engineering strain.
TEST(Umat, is_given_what_the_guide_says)
{
  MaterialConstants constants      = probe_constants(echo);
  constants.n_umat_state_variables = 14;
  const Umat             umat(constants);
  SymmetricComponents<6> stress;
  stress << 1., 2., 3., 4., 5., 6.; // xx yy zz xy yz xz
  auto         state = umat.initial_state();
  Increment<6> increment;
  increment.strain << 0.1, 0.2, 0.3, 0.4, 0.5, 0.6;
  const double work =
    umat.correct(stress, state, umat.predict(increment, 1e-4));
  const double strain[6] = {0.1, 0.2, 0.3, 0.8, 1.2, 1.0};
  for (unsigned int c = 0; c < 6; ++c)
    {
      EXPECT_DOUBLE_EQ(state[c], strain[c]);
      EXPECT_EQ(stress[c], c + 1.);
    }
  EXPECT_EQ(state[6], 0.);
  EXPECT_EQ(state[7], 1e-4);
  EXPECT_EQ(state[8], 3 + 10 * 3 + 100 * 14 + 10000 * 2);
  EXPECT_EQ(state[9], 1.);
  EXPECT_DOUBLE_EQ(state[10], 0.4);
  EXPECT_EQ(state[11], 5.); // 23 is our yz
  EXPECT_EQ(state[12], 1.);
  EXPECT_EQ(state[13], 0.);
  EXPECT_EQ(state[14], 0.);
  // 0.1 + 2 0.2 + 3 0.3 + 2 (4 0.4 + 5 0.5 + 6 0.6)
  EXPECT_DOUBLE_EQ(work, 16.8);
}



// DROT turns counterclockwise with the material, and is a rotation although
// forward Euler's is not quite one.
TEST(Umat, is_given_the_rotation)
{
  MaterialConstants constants      = probe_constants(echo);
  constants.n_umat_state_variables = 14;
  const Umat             umat(constants);
  SymmetricComponents<4> stress = SymmetricComponents<4>::Zero();
  const double           spin   = 0.01;
  for (const auto &rotation : {InPlaneRotation<double>::forward_euler(spin),
                               InPlaneRotation<double>::hughes_winget(spin)})
    {
      auto            state = umat.initial_state();
      TurnedIncrement increment;
      increment.strain.setZero();
      increment.rotation = rotation;
      umat.correct(stress, state, umat.predict(increment, 1e-4));
      EXPECT_NEAR(state[6], -std::sin(spin), 2e-6); // third order in the spin
      EXPECT_EQ(state[10], state[6]);
      EXPECT_EQ(state[8], 3 + 10 * 1 + 100 * 14 + 10000 * 2);
    }
}



TEST(Umat, is_given_the_rotation_in_space)
{
  MaterialConstants constants      = probe_constants(echo);
  constants.n_umat_state_variables = 14;
  const Umat             umat(constants);
  SymmetricComponents<6> stress = SymmetricComponents<6>::Zero();
  auto                   state  = umat.initial_state();
  TurnedIncrementInSpace increment;
  increment.strain.setZero();
  increment.rotation.entries = {{1., 2., 3., 4., 5., 6., 7., 8., 9.}};
  umat.correct(stress, state, umat.predict(increment, 1e-4));
  EXPECT_EQ(state[6], 2.); // DROT(1, 2)
}



// Where particles of a cell deform differently, the prediction has lanes too.
TEST(Umat, lanes_may_each_have_their_own_increment)
{
  MaterialConstants constants      = probe_constants(echo);
  constants.n_umat_state_variables = 14;
  const Umat umat(constants);

  alignas(Lanes) const double         numbers[4] = {0.01, 0.02, 0.03, 0.04};
  const Lanes                         lanes      = Lanes::load(numbers);
  std::array<std::array<Lanes, 2>, 2> gradient;
  gradient[0] = {{lanes, Lanes(0.)}};
  gradient[1] = {{Lanes(0.), Lanes(0.)}};
  InPlaneIncrement<Lanes> increment(gradient, Lanes(0.));
  increment.rotation = InPlaneRotation<Lanes>::forward_euler(lanes);
  SymmetricComponents<4, Lanes> stress = isotropic<4>(Lanes(-1.));
  LawState<Umat, Lanes>         state;
  state.fill(Lanes(0.));
  const Lanes work = umat.correct(stress, state, umat.predict(increment, 1e-4));
  for (unsigned int lane = 0; lane < 4; ++lane)
    {
      EXPECT_EQ(state[0][lane], numbers[lane]);
      EXPECT_NEAR(state[6][lane], -std::sin(numbers[lane]), 1e-4);
      EXPECT_EQ(state[7][lane], 1e-4);
      EXPECT_EQ(work[lane], -numbers[lane]);
      EXPECT_EQ(stress[1][lane], -1.);
    }
}



TEST(Umat, tangent_is_what_the_subroutine_says)
{
  const Umat             umat(probe_constants(elastic));
  const auto             state = umat.initial_state();
  SymmetricComponents<6> stress;
  stress << 1., 2., 3., 4., 5., 6.;
  Increment<6> increment;
  increment.strain << 0.1, 0.2, 0.3, 0.4, 0.5, 0.6;
  const auto tangent        = umat.tangent(stress, state, increment, 0.);
  const auto by_differences = numerical_tangent(umat, stress, state, increment);
  EXPECT_LT((tangent.by_strain - by_differences.by_strain).norm(),
            1e-6 * tangent.by_strain.norm());
  EXPECT_EQ(tangent.by_strain(3, 4), 2. * 1e4 * (4 + 10 * 6)); // 12 by 23
  EXPECT_EQ(tangent.by_strain(5, 0), 1e4 * (5 + 10));          // 13 by 11
}



TEST(Umat, library_that_cannot_be_used_is_refused)
{
  MaterialConstants constants = probe_constants(elastic);
  constants.umat_library      = "";
  expect_contains(refusal_of(constants), "the path of a shared library");
  constants.umat_library = "no-such-library.so";
  expect_contains(refusal_of(constants), "there is no such file");
  expect_contains(refusal_of(constants), "'no-such-library.so'");
  constants.umat_library = __FILE__;
  expect_contains(refusal_of(constants), "can't be loaded as a shared library");
  constants.umat_library = SANDGLASS_UMAT_EMPTY;
  expect_contains(refusal_of(constants), "neither umat_");
  constants                        = probe_constants(elastic);
  constants.n_umat_state_variables = Umat::max_state_variables + 1;
  expect_contains(refusal_of(constants), "value '21': at most 20");
}



TEST(Umat, failures_say_what_was_given)
{
  EXPECT_EQ(failure_of(elastic), "");
  const std::string smaller_step = failure_of(ask_for_smaller_step);
  expect_contains(smaller_step, "the law UMAT failed: it asks for a smaller");
  expect_contains(smaller_step, "PNEWDT = 0.5");
  expect_contains(smaller_step, "(-1000, -2000, -1500, 900)");
  expect_contains(smaller_step, "(0.001, -0.002, 0.0005, 0.002)");
  expect_contains(failure_of(return_nan), "not finite");
  expect_contains(failure_of(call_xit), "it called XIT");
  expect_contains(failure_of(call_abqerr), "no such sand");
}



// The library stays loaded as long as a copy of the law lives.
TEST(Umat, copies_share_the_library)
{
  MaterialConstants constants = probe_constants(elastic);
  EXPECT_TRUE(Umat::is_meant(constants));
  EXPECT_FALSE(Umat::is_meant(MaterialConstants()));
  std::unique_ptr<const Umat> copy;
  {
    const Umat umat(constants);
    copy = std::make_unique<const Umat>(umat);
  }
  auto                   state  = copy->initial_state();
  SymmetricComponents<4> stress = SymmetricComponents<4>::Zero();
  Increment<4>           increment;
  increment.strain << 1., 0., 0., 0.;
  copy->correct(stress, state, copy->predict(increment, 1e-4));
  EXPECT_EQ(stress[1], 1e4 * (2 + 10));
}
