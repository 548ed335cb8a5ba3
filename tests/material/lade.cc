// Lade's law against its equations.

#include <sandglass/material/lade.h>

#include <gtest/gtest.h>

#include "../random_engine.h"

using namespace Sandglass;

namespace
{
  template <int n>
  struct Increment
  {
    SymmetricComponents<n> strain;
  };

  constexpr double atmosphere = LadeConstants::atmospheric_pressure;

  MaterialConstants
  constants_with(const std::map<std::string, double> &law_constants)
  {
    MaterialConstants constants;
    constants.model         = "Lade";
    constants.poisson_ratio = 0.2;
    constants.law_constants = law_constants;
    return constants;
  }

  double
  constant(const char *const name)
  {
    return law_constant<Lade>(MaterialConstants(), name);
  }

  template <int n>
  void
  strain_by(const Lade                   &law,
            const SymmetricComponents<n> &strain,
            SymmetricComponents<n>       &stress,
            std::array<double, 2>        &state)
  {
    law.correct(stress, state, law.predict(Increment<n>{strain}, 0.));
  }

  /// One step of a drained triaxial test: y is strained, and x and z such that
  /// their stress stays. The lateral strain is found by Newton's method.
  void
  triaxial_step(const Lade             &law,
                const double            axial_strain,
                const double            lateral_stress,
                SymmetricComponents<4> &stress,
                std::array<double, 2>  &state,
                double                 &lateral_strain)
  {
    const auto stress_at = [&](const double lateral) {
      auto trial       = stress;
      auto trial_state = state;
      strain_by<4>(law,
                   {lateral, axial_strain, lateral, 0.},
                   trial,
                   trial_state);
      return trial[0];
    };
    const double difference = 1e-3 * axial_strain;
    for (unsigned int i = 0; i < 30; ++i)
      {
        const double residual = stress_at(lateral_strain) - lateral_stress;
        const double slope    = (stress_at(lateral_strain + difference) -
                              stress_at(lateral_strain - difference)) /
                             (2. * difference);
        lateral_strain -= residual / slope;
      }
    strain_by<4>(law,
                 {lateral_strain, axial_strain, lateral_strain, 0.},
                 stress,
                 state);
  }

  /// A stress in the cone, an increment that yields.
  template <int n>
  void
  random_case(std::mt19937           &engine,
              SymmetricComponents<n> &stress,
              SymmetricComponents<n> &strain)
  {
    std::normal_distribution<double> normal;
    stress = isotropic<n>(-2e4);
    for (int c = 0; c < n; ++c)
      {
        stress[c] += 2e3 * normal(engine);
        strain[c] = 1e-3 * normal(engine) - (c < 3 ? 5e-4 : 0.);
      }
  }
} // namespace



// Loose sand at 100 kPa: f_p rises to eta_1 and stays there.
TEST(Lade, drained_triaxial_test_fails_at_eta_1)
{
  const Lade             law(constants_with({{"p_t", 1e-2}, {"dilation", 1.}}));
  auto                   state     = law.initial_state();
  SymmetricComponents<4> stress    = isotropic<4>(0.);
  const double           confining = -1e5;
  while (stress[0] > confining)
    strain_by<4>(law, isotropic<4>(-1e-6), stress, state);
  EXPECT_LT(law.surfaces(stress, state).cone, 1e-6);

  double lateral = 0., previous = 0.;
  for (unsigned int step = 0; step < 400; ++step)
    {
      triaxial_step(law, -1e-3, stress[0], stress, state, lateral);
      const double cone = law.surfaces(stress, state).cone;
      EXPECT_GT(cone, previous - 1e-4);
      previous = cone;
    }
  EXPECT_NEAR(previous, constant("eta_1"), 1e-4 * constant("eta_1"));

  // (I1^3 / I3 - 27) (I1 / p_a)^m, written out
  const double a = -stress[1], r = -stress[0];
  const double sum = a + 2. * r;
  EXPECT_NEAR((sum * sum * sum / (a * r * r) - 27.) *
                std::pow(sum / atmosphere, constant("m")),
              constant("eta_1"),
              2e-3); // p_t
  // Strains at failure are those of the plastic potential: no elastic ones.
  const double eta_2 = constant("S") * constant("eta_1") +
                       constant("R") * std::sqrt(r / atmosphere);
  const double factor = 27. + eta_2 * std::pow(atmosphere / sum, constant("m"));
  const double common =
    3. * sum * sum + constant("m") * eta_2 / sum *
                       std::pow(atmosphere / sum, constant("m")) * a * r * r;
  EXPECT_NEAR(lateral / -1e-3,
              (common - factor * a * r) / (common - factor * r * r),
              1e-3);
}



// Only the cap yields: elastic and plastic strain have closed forms.
TEST(Lade, isotropic_compression_follows_the_cap)
{
  const double floor = 10.;
  const Lade   law(constants_with({{"p_t", floor}, {"tolerance", 1e-6}}));
  auto         state            = law.initial_state();
  SymmetricComponents<6> stress = isotropic<6>(0.);
  double                 volume = 0.;
  for (unsigned int step = 1; step <= 200; ++step)
    {
      strain_by<6>(law, isotropic<6>(-1e-5), stress, state);
      volume += 3e-5;
    }
  const double n = constant("n"), C = constant("C"), p = constant("p");
  const auto   strain = [&](const double pressure) {
    const double x = pressure / atmosphere;
    return 3. * (1. - 2. * 0.2) / constant("K_ur") * std::pow(x, 1. - n) /
             (1. - n) +
           6. * C * p * std::pow(3., p - 1.) * std::pow(x, 2. * p - 1.) /
             (2. * p - 1.);
  };
  const double pressure = -stress[0];
  EXPECT_GT(pressure, 1e4);
  EXPECT_NEAR(strain(pressure + floor) - strain(floor), volume, 1e-4 * volume);
  EXPECT_NEAR(state[1],
              C * atmosphere *
                std::pow(3. * std::pow((pressure + floor) / atmosphere, 2.), p),
              1e-4 * state[1]);

  // Unloading is elastic.
  const auto loaded = state;
  strain_by<6>(law, isotropic<6>(1e-4), stress, state);
  EXPECT_EQ(state, loaded);
  const auto elastic = [&](const double pressure) {
    return 3. * (1. - 2. * 0.2) / constant("K_ur") *
           std::pow(pressure / atmosphere, 1. - n) / (1. - n);
  };
  EXPECT_NEAR(elastic(pressure + floor) - elastic(floor - stress[0]),
              3e-4,
              1e-4 * 3e-4);
}



TEST(Lade, surfaces_gradients_are_those_of_their_values)
{
  std::mt19937 engine = random_engine();
  const Lade   law(constants_with({{"residual", 0.5}}));
  for (unsigned int i = 0; i < 20; ++i)
    {
      SymmetricComponents<6> stress, unused;
      random_case(engine, stress, unused);
      // before and after the peak
      const std::array<double, 2> work = {{i % 2 == 0 ? 500. : 5e3, 100.}};
      const auto                  at   = law.surfaces(stress, work);
      for (int c = 0; c < 6; ++c)
        {
          auto more = stress, less = stress;
          more[c] += 0.5;
          less[c] -= 0.5;
          const auto high = law.surfaces(more, work);
          const auto low  = law.surfaces(less, work);
          for (unsigned int s = 0; s < 2; ++s)
            EXPECT_NEAR(-at.gradient[s][c] * (c < 3 ? 1. : 2.),
                        high.excess[s] - low.excess[s],
                        1e-5 * at.gradient[s].norm());
        }
      auto more = work, less = work;
      for (unsigned int s = 0; s < 2; ++s)
        {
          more[s] += 1e-3 * work[s];
          less[s] -= 1e-3 * work[s];
        }
      for (unsigned int s = 0; s < 2; ++s)
        EXPECT_NEAR(at.hardening[s],
                    (law.surfaces(stress, less).excess[s] -
                     law.surfaces(stress, more).excess[s]) /
                      (2e-3 * work[s]),
                    1e-5 * std::abs(at.hardening[s]));
    }
}



// Lade's own form, with a and b from the work at the peak.
TEST(Lade, cone_hardens_as_lade_writes_it)
{
  const Lade law(constants_with({{"residual", 0.01}, {"conservative", 0.}}));
  SymmetricComponents<4> stress(-5e4, -8e4, -3e4, 0.);
  const double           smallest = (3e4 + constant("p_t")) / atmosphere;
  const double           q = constant("alpha") + constant("beta") * smallest;
  const double           peak =
    constant("P") * atmosphere * std::pow(smallest, constant("l"));
  const double a =
    constant("eta_1") * std::pow(std::exp(1.) * atmosphere / peak, 1. / q);
  const double b = 1. / (q * peak);
  for (const double work : {0.1 * peak, peak, 3. * peak})
    {
      const auto at = law.surfaces(stress, {{work, 1.}});
      EXPECT_NEAR(at.cone - constant("eta_1") * at.excess[0],
                  a * std::exp(-b * work) * std::pow(work / atmosphere, 1. / q),
                  1e-9);
    }
  // Stiffness by the smallest principal stress.
  EXPECT_DOUBLE_EQ(law.surfaces(stress, {{1., 1.}}).elasticity().shear_modulus,
                   constant("K_ur") * atmosphere *
                     std::pow(smallest, constant("n")) / 2.4);
}



// Small closed cycles of strain from a stress between cone and axis. With the
// elasticity of 1977 what work brings in beyond what is stored and dissipated
// is a third of the latter.
TEST(Lade, elasticity_conserves_energy)
{
  const auto imbalance = [](const double conservative) {
    std::mt19937                     engine = random_engine();
    std::normal_distribution<double> normal;
    const Lade law(constants_with({{"conservative", conservative}}));
    SymmetricComponents<4> stress(-1e3, -2e3, -1e3, 0.), strain;
    auto                   state = law.initial_state();
    strain << 0., -1e-6, 0., 0.;
    for (unsigned int n = 0; n < 1000; ++n)
      strain_by<4>(law, strain, stress, state);

    constexpr unsigned int n_cycles = 100, n_steps = 20;
    const double           start = law.energy_density(stress, state);
    double                 work = 0., dissipated = 0.;
    for (unsigned int cycle = 0; cycle < n_cycles; ++cycle)
      {
        for (int c = 0; c < 4; ++c)
          strain[c] = 1e-5 / n_steps * normal(engine);
        for (const double sign : {1., -1.})
          for (unsigned int n = 0; n < n_steps; ++n)
            {
              const SymmetricComponents<4> before    = stress;
              const SymmetricComponents<4> increment = sign * strain;
              dissipated += law.correct(stress, state, increment);
              const SymmetricComponents<4> middle = 0.5 * (before + stress);
              work += double_contraction(middle, increment);
            }
      }
    const double stored = law.energy_density(stress, state) - start;
    std::cout << "work " << work << ", stored " << stored << ", dissipated "
              << dissipated << std::endl;
    return std::abs(work - stored - dissipated) / dissipated;
  };
  EXPECT_LT(imbalance(1.), 3e-3);
  EXPECT_GT(imbalance(0.), 0.1);
}



// The plastic flow of the cone is normal to g_p = I1^3 - (27 + eta_2 (p_a /
// I1)^m) I3.
TEST(Lade, flow_is_normal_to_the_potential)
{
  std::mt19937           engine = random_engine();
  const Lade             law(constants_with({}));
  SymmetricComponents<6> stress, unused;
  random_case(engine, stress, unused);
  const std::array<double, 2> work = {{500., 100.}};
  const auto                  at   = law.surfaces(stress, work);
  const double                eta_2 =
    constant("S") * at.cone +
    constant("R") * std::sqrt(at.smallest_stress / atmosphere);
  const auto potential = [&](const SymmetricComponents<6> &s) {
    const double first = trace(s);
    return first * first * first -
           (27. + eta_2 * std::pow(atmosphere / first, constant("m"))) *
             determinant(s);
  };
  SymmetricComponents<6> normal;
  for (int c = 0; c < 6; ++c)
    {
      auto more = at.stress, less = at.stress;
      more[c] += 1.;
      less[c] -= 1.;
      normal[c] = (potential(more) - potential(less)) / (c < 3 ? 2. : 4.) /
                  at.first / at.first;
    }
  EXPECT_LT((normal - at.flow[0]).norm(), 1e-6 * normal.norm());
}



TEST(Lade, four_components_give_what_six_do_and_lanes_what_doubles_do)
{
  std::mt19937 engine = random_engine();
  const Lade   law(constants_with({}));
  for (unsigned int i = 0; i < 100; ++i)
    {
      SymmetricComponents<4> stress, strain;
      random_case(engine, stress, strain);
      auto                   state  = law.initial_state();
      auto                   state6 = state;
      SymmetricComponents<6> stress6, strain6;
      stress6 << stress, 0., 0.;
      strain6 << strain, 0., 0.;

      SymmetricComponents<4, Lanes> lanes;
      std::array<Lanes, 2> lane_state = {{Lanes(state[0]), Lanes(state[1])}};
      for (int c = 0; c < 4; ++c)
        {
          // Other stresses in the other lanes.
          alignas(
            Lanes) double values[4] = {0., 0.5 * stress[c], stress[c], -5.};
          lanes[c]                  = Lanes::load(values);
        }
      const Lanes  lane_work = law.correct(lanes, lane_state, strain);
      const double work      = law.correct(stress, state, strain);
      const double work6     = law.correct(stress6, state6, strain6);
      EXPECT_NEAR(work, work6, 1e-9 * (std::abs(work) + 1.));
      EXPECT_EQ(lane_work[2], work);
      for (int c = 0; c < 4; ++c)
        {
          EXPECT_NEAR(stress[c], stress6[c], 1e-9 * stress.norm());
          EXPECT_EQ(lanes[c][2], stress[c]);
        }
      EXPECT_EQ(stress6[4], 0.);
      EXPECT_EQ(stress6[5], 0.);
      for (unsigned int s = 0; s < 2; ++s)
        EXPECT_EQ(lane_state[s][2], state[s]);
    }
}



// A rotation of the axes (x -> y -> z) must not change what the law does.
TEST(Lade, no_direction_is_special)
{
  std::mt19937 engine = random_engine();
  const Lade   law(constants_with({}));
  const auto   turn = [](const SymmetricComponents<6> &a) {
    SymmetricComponents<6> turned;
    turned << a[2], a[0], a[1], a[5], a[3], a[4];
    return turned;
  };
  for (unsigned int i = 0; i < 100; ++i)
    {
      SymmetricComponents<6> stress, strain;
      random_case(engine, stress, strain);
      auto                   state = law.initial_state(), turned_state = state;
      SymmetricComponents<6> turned = turn(stress);
      strain_by<6>(law, turn(strain), turned, turned_state);
      strain_by<6>(law, strain, stress, state);
      EXPECT_LE((turned - turn(stress)).norm(), 1e-9 * stress.norm());
      EXPECT_GT(state[0], 0.);
    }
}



/// The largest relative difference of random increments in one step from the
/// same in thirty, with a bound on the error as tight as can be.
double
largest_error(const Lade &law)
{
  std::mt19937 engine = random_engine();
  const Lade   tight(constants_with({{"tolerance", 1e-7}}));
  double       largest = 0.;
  for (unsigned int i = 0; i < 20; ++i)
    {
      // A first increment, so that works and stress belong together.
      auto                   state = law.initial_state();
      SymmetricComponents<6> stress, strain, first_strain;
      random_case(engine, stress, first_strain);
      random_case(engine, stress, strain);
      strain_by<6>(tight, first_strain, stress, state);
      auto exact       = stress;
      auto exact_state = state;
      strain_by<6>(law, strain, stress, state);
      for (unsigned int step = 0; step < 30; ++step)
        strain_by<6>(tight, strain / 30., exact, exact_state);
      if (exact.norm() > 0.)
        largest = std::max(largest, (stress - exact).norm() / exact.norm());

      // On or inside both surfaces.
      const auto at = law.surfaces(stress, state);
      for (unsigned int s = 0; s < 2; ++s)
        EXPECT_LE(at.excess[s], 1.001 * at.tolerance[s]);
    }
  std::cout << "largest error " << largest << std::endl;
  return largest;
}



TEST(Lade, tolerance_bounds_the_error)
{
  EXPECT_LT(largest_error(Lade(constants_with({}))), 1e-3);
  EXPECT_LT(largest_error(Lade(constants_with({{"tolerance", 1e-6}}))), 1e-4);
}



TEST(Lade, tension_leaves_no_stress)
{
  const Lade             law(constants_with({}));
  auto                   state = law.initial_state();
  SymmetricComponents<4> stress(-1e3, -2e3, -1.5e3, 300.);
  strain_by<4>(law, {1e-2, 1e-2, 0., 1e-3}, stress, state);
  EXPECT_EQ(stress.norm(), 0.);
  strain_by<4>(law, {1e-2, 0., 0., 0.}, stress, state);
  EXPECT_EQ(stress.norm(), 0.);
  auto                   tension_state = state;
  SymmetricComponents<4> tension(2e3, 1e3, 1e3, 300.);
  strain_by<4>(law, {0., -1e-3, 0., 0.}, stress, state);
  EXPECT_LT(stress[1], -100.);

  // A tension at the start is none.
  strain_by<4>(law, {0., -1e-3, 0., 0.}, tension, tension_state);
  EXPECT_EQ(tension, stress);
}



// Half of eta_1 stays after the peak if the user says so.
TEST(Lade, softens_to_the_residual_strength)
{
  const Lade             law(constants_with({{"residual", 0.5}}));
  auto                   state   = law.initial_state();
  SymmetricComponents<4> stress  = isotropic<4>(-1e4);
  double                 lateral = 0., peak = 0., cone = 0.;
  for (unsigned int step = 0; step < 400; ++step)
    {
      triaxial_step(law, -1e-3, -1e4, stress, state, lateral);
      cone = law.surfaces(stress, state).cone;
      peak = std::max(peak, cone);
    }
  EXPECT_NEAR(peak, constant("eta_1"), 0.01 * constant("eta_1"));
  EXPECT_NEAR(cone, 0.5 * constant("eta_1"), 1e-3 * constant("eta_1"));
}



// Volume grows up to the peak and some way beyond, and then no longer.
TEST(Lade, dilation_fades_after_the_peak)
{
  const Lade             law(constants_with({}));
  auto                   state   = law.initial_state();
  SymmetricComponents<4> stress  = isotropic<4>(-1e4);
  double                 lateral = 0., expansion = 0.;
  for (unsigned int step = 0; step < 800; ++step)
    {
      triaxial_step(law, -1e-3, -1e4, stress, state, lateral);
      expansion += 2. * lateral - 1e-3;
      if (step == 50)
        {
          EXPECT_GT(lateral, 0.6e-3);
        }
    }
  EXPECT_NEAR(lateral, 0.5e-3, 1e-5);
  EXPECT_GT(std::exp(-expansion), law.loosest_density_share());
}



TEST(Lade, tangent_predicts_the_change_of_stress)
{
  std::mt19937 engine = random_engine();
  const Lade   law(constants_with({{"tolerance", 1e-7}}));
  for (unsigned int i = 0; i < 20; ++i)
    {
      SymmetricComponents<4> start, strain;
      random_case(engine, start, strain);
      const auto state   = law.initial_state();
      const auto tangent = law.tangent(start, state, Increment<4>{strain}, 0.);
      const auto at      = [&](const double share) {
        auto stress    = start;
        auto new_state = state;
        strain_by<4>(law, share * strain, stress, new_state);
        return stress;
      };
      const SymmetricComponents<4> change =
        (at(1. + 1e-4) - at(1. - 1e-4)) / 2e-4;
      const auto elastic = law.tangent(start, state, Increment<4>{strain}, 1.);
      // 1e-3 of the elastic stiffness is in the tangent.
      const SymmetricComponents<4> expected =
        0.999 * change + 1e-3 * elastic.by_strain * strain;
      EXPECT_LT((tangent.by_strain * strain - expected).norm(),
                2e-2 * change.norm());
      EXPECT_EQ(elastic.by_strain,
                law.stiffness_bound(start, state).stiffness<4>());
    }
}



// What no run should do: nothing may hang, or be no number.
TEST(Lade, extreme_input_leaves_finite_stress)
{
  std::mt19937                           engine = random_engine();
  std::uniform_real_distribution<double> unit(-1., 1.);
  std::normal_distribution<double>       normal;
  for (unsigned int i = 0; i < 300; ++i)
    {
      const Lade   law(constants_with({{"residual", i % 3 == 0 ? 0.01 : 1.}}));
      const double range = i % 2 == 0 ? 200. : 8.;
      SymmetricComponents<6> stress, strain;
      const double           stress_size = std::pow(10., range * unit(engine));
      const double strain_size = std::pow(10., 0.5 * range * unit(engine));
      for (int c = 0; c < 6; ++c)
        {
          stress[c] = stress_size * (normal(engine) - (c < 3 ? 2. : 0.));
          strain[c] = strain_size * normal(engine);
        }
      std::array<double, 2> state = {
        {std::pow(10., 10. * unit(engine)), std::pow(10., 10. * unit(engine))}};
      const double work = law.correct(stress, state, strain);
      ASSERT_TRUE(stress.allFinite()) << i;
      ASSERT_TRUE(std::isfinite(state[0]) && std::isfinite(state[1]));
      ASSERT_TRUE(std::isfinite(work));
      ASSERT_GE(pressure(stress), 0.);
      ASSERT_TRUE(std::isfinite(law.energy_density(stress, state)));
    }
  // What is not a number must be seen.
  const Lade             law(constants_with({}));
  SymmetricComponents<4> stress(-1e3, -2e3, std::nan(""), 0.);
  auto                   state = law.initial_state();
  strain_by<4>(law, SymmetricComponents<4>::Zero(), stress, state);
  EXPECT_TRUE(std::isnan(stress[0]));
}



TEST(Lade, unstressed_material_has_the_stiffness_of_the_floor)
{
  const Lade   law(constants_with({}));
  const double modulus = constant("K_ur") * atmosphere *
                         std::pow(constant("p_t") / atmosphere, constant("n"));
  EXPECT_DOUBLE_EQ(law.stiffness_bound().shear_modulus, modulus / 2.4);
  EXPECT_EQ(law.loosest_density_share(), 0.9);
  EXPECT_TRUE(Lade::is_meant(constants_with({})));
  EXPECT_FALSE(Lade::is_meant(MaterialConstants()));

  // Half of the stress's work at constant stiffness, and more since it falls.
  const SymmetricComponents<4> stress = isotropic<4>(-1e5);
  const auto                   state  = law.initial_state();
  const double bulk = law.stiffness_bound(stress, state).bulk_modulus();
  EXPECT_DOUBLE_EQ(law.energy_density(stress, state),
                   1e10 / bulk / (2. - constant("n")));
}
