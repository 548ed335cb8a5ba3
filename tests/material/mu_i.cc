// mu(I): its return in closed form is the solution of its equation.

#include <sandglass/material/mu_i.h>

#include <gtest/gtest.h>

using namespace Sandglass;

namespace
{
  constexpr double pi = 3.14159265358979323846;

  struct Increment
  {
    SymmetricComponents<4> strain;
  };

  MaterialConstants
  glass_beads(const double diameter = 1e-3, const double cohesion = 0.)
  {
    MaterialConstants constants;
    constants.model                   = MuI::name;
    constants.internal_friction_angle = 20.9;
    constants.cohesion                = cohesion;
    constants.law_constants["d"]      = diameter;
    return constants;
  }

  /// tau after a step that would elastically lead to tau_trial, by bisection of
  /// tau = tau_trial - G dt rate, tau = c + mu(I(rate)) p.
  double
  tau_by_bisection(const MaterialConstants &constants,
                   const double             pressure,
                   const double             tau_trial,
                   const double             time_step)
  {
    const Elasticity elasticity(constants.young_modulus,
                                constants.poisson_ratio);
    const double     slow = std::tan(friction_angle(constants)),
                 fast     = std::tan(32.76 * pi / 180.);
    const double diameter = law_constant<MuI>(constants, "d");
    const auto   strength = [&](const double rate) {
      const double inertial_number =
        rate * diameter * std::sqrt(2500. / pressure);
      return constants.cohesion +
             (slow + (fast - slow) / (1. + 0.278 / inertial_number)) * pressure;
    };
    double lower = constants.cohesion, upper = tau_trial;
    for (unsigned int n = 0; n < 200; ++n)
      {
        const double tau = 0.5 * (lower + upper);
        const double rate =
          (tau_trial - tau) / (elasticity.shear_modulus * time_step);
        (strength(rate) > tau ? lower : upper) = tau;
      }
    return lower;
  }

  double
  tau_of(const MuI                    &law,
         const SymmetricComponents<4> &start,
         const double                  time_step)
  {
    SymmetricComponents<4> stress = start;
    std::array<double, 0>  none;
    law.correct(stress,
                none,
                law.predict(Increment{SymmetricComponents<4>::Zero()},
                            time_step));
    EXPECT_NEAR(pressure(stress), pressure(start), 1e-9);
    return von_mises_stress(stress) / std::sqrt(3.);
  }
} // namespace



TEST(MuI, return_solves_its_equation)
{
  for (const double diameter : {1e-5, 1e-3, 1e-1})
    for (const double cohesion : {0., 300.})
      for (const double time_step : {1e-6, 1e-4, 1e-2})
        for (const double tau : {700., 1200., 5000.})
          {
            const auto constants = glass_beads(diameter, cohesion);
            EXPECT_NEAR(tau_of(MuI(constants),
                               {-1e3, -1e3, -1e3, tau},
                               time_step) /
                          tau_by_bisection(constants, 1e3, tau, time_step),
                        1.,
                        1e-9)
              << diameter << ' ' << cohesion << ' ' << time_step << ' ' << tau;
          }
}



TEST(MuI, is_elastic_below_slow_friction_and_plastic_at_rest)
{
  const MuI    law(glass_beads());
  const double slow = 1e3 * std::tan(20.9 * pi / 180.);
  EXPECT_EQ(tau_of(law, {-1e3, -1e3, -1e3, 0.99 * slow}, 1e-5), 0.99 * slow);
  // A load step of the state at rest has no time.
  EXPECT_NEAR(tau_of(law, {-1e3, -1e3, -1e3, 5e3}, 0.), slow, 1e-9 * slow);
  // Grains without size have no rate.
  EXPECT_NEAR(tau_of(MuI(glass_beads(0.)), {-1e3, -1e3, -1e3, 5e3}, 1e-5),
              slow,
              1e-6 * slow);
}



// Simple shear at a constant rate ends at mu(I) of that rate.
TEST(MuI, steady_shear_has_mu_of_its_rate)
{
  const MuI              law(glass_beads());
  constexpr double       rate = 50., time_step = 1e-5;
  SymmetricComponents<4> stress = isotropic<4>(-1e3);
  std::array<double, 0>  none;
  for (unsigned int n = 0; n < 20000; ++n)
    law.correct(stress,
                none,
                law.predict(Increment{{0., 0., 0., 0.5 * rate * time_step}},
                            time_step));
  const double number = rate * 1e-3 * std::sqrt(2500. / 1e3);
  const double slow   = std::tan(20.9 * pi / 180.),
               fast   = std::tan(32.76 * pi / 180.);
  EXPECT_NEAR(stress[3] / 1e3,
              slow + (fast - slow) / (1. + 0.278 / number),
              1e-6);
}



TEST(MuI, refuses_fast_friction_below_slow)
{
  MaterialConstants constants       = glass_beads();
  constants.internal_friction_angle = 40.;
  EXPECT_THROW(MuI law(constants), InputError);
}
