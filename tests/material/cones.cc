// Which friction angle acts with each cone, cohesion, and Matsuoka and Nakai's
// return.

#include <sandglass/material/matsuoka_nakai.h>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <random>

using namespace Sandglass;

namespace
{
  constexpr double pi = 3.14159265358979323846;

  struct Increment
  {
    SymmetricComponents<4> strain;
  };

  MaterialConstants
  constants_of(const YieldCone cone,
               const double    friction_angle,
               const double    cohesion = 0.)
  {
    MaterialConstants constants;
    constants.yield_cone              = cone;
    constants.internal_friction_angle = friction_angle;
    constants.cohesion                = cohesion;
    return constants;
  }

  /// asin of the largest shear stress over the mean of the extreme principal
  /// stresses, in degrees.
  double
  mobilised_angle(const SymmetricComponents<4> &stress)
  {
    const double mean    = 0.5 * (stress[0] + stress[1]);
    const double radius  = std::hypot(0.5 * (stress[0] - stress[1]), stress[3]);
    const double largest = std::max(mean + radius, stress[2]),
                 smallest = std::min(mean - radius, stress[2]);
    return std::asin((smallest - largest) / (smallest + largest)) * 180. / pi;
  }

  /// The angle that acts in the end in a uniform deformation.
  template <typename Law>
  double
  realised_angle(const Law &law, const SymmetricComponents<4> &direction)
  {
    SymmetricComponents<4> stress = isotropic<4>(-1e4);
    std::array<double, 0>  none;
    for (unsigned int n = 0; n < 20000; ++n)
      law.correct(stress, none, law.predict(Increment{1e-5 * direction}, 1.));
    return mobilised_angle(stress);
  }

  const SymmetricComponents<4> plane(1., -1., 0., 0.), shear(0., 0., 0., 1.),
    compression(0.5, -1., 0.5, 0.), extension(-0.5, 1., -0.5, 0.);

  std::mt19937 random_numbers(20261129);

  template <int n>
  SymmetricComponents<n>
  random_stress()
  {
    std::uniform_real_distribution<double> number(-1., 1.);
    SymmetricComponents<n>                 stress;
    for (int c = 0; c < n; ++c)
      stress[c] = 1e3 * number(random_numbers);
    return stress - isotropic<n>(1000.);
  }

  /// I1 I2 / I3 of a stress.
  double
  matsuoka_nakai_ratio(const SymmetricComponents<6> &s)
  {
    Eigen::Matrix3d tensor;
    tensor << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
    const double first  = tensor.trace();
    const double second = 0.5 * (first * first - (tensor * tensor).trace());
    return first * second / tensor.determinant();
  }
} // namespace



TEST(Cones, realise_the_typed_angle_where_they_promise_it)
{
  for (const double angle : {5., 15., 25., 35., 45., 55.})
    {
      const DruckerPrager in_plane(
        constants_of(YieldCone::plane_strain, angle));
      EXPECT_NEAR(realised_angle(in_plane, plane), angle, 0.01);
      EXPECT_NEAR(realised_angle(in_plane, shear), angle, 0.01);
      const DruckerPrager compressed(
        constants_of(YieldCone::compression, angle));
      EXPECT_NEAR(realised_angle(compressed, compression), angle, 0.01);
      const MatsuokaNakai both(constants_of(YieldCone::matsuoka_nakai, angle));
      EXPECT_NEAR(realised_angle(both, compression), angle, 0.01);
      EXPECT_NEAR(realised_angle(both, extension), angle, 0.01);
      // Plane flow with s_zz = 0: sin'^2 = 4 sin^2 / (3 + sin^2).
      const double sine = std::sin(angle * pi / 180.);
      const double in_plane_flow =
        std::asin(2. * sine / std::sqrt(3. + sine * sine)) * 180. / pi;
      EXPECT_NEAR(realised_angle(both, plane), in_plane_flow, 0.01);
    }
  // The paper's material of 25 degrees.
  const DruckerPrager paper(constants_of(YieldCone::paper, 25.));
  EXPECT_NEAR(realised_angle(paper, plane), 29.86, 0.01);
}



TEST(Cones, matsuoka_and_nakai_return_to_their_cone)
{
  for (const double angle : {1., 10., 25., 40., 60., 80.})
    {
      const MatsuokaNakai law(constants_of(YieldCone::matsuoka_nakai, angle));
      const double        square     = std::pow(std::sin(angle * pi / 180.), 2);
      const double        ratio      = (9. - square) / (1. - square);
      unsigned int        n_yielding = 0;
      for (unsigned int n = 0; n < 200; ++n)
        {
          SymmetricComponents<6>       stress = random_stress<6>();
          const SymmetricComponents<6> trial  = stress;
          law.project(stress);
          if (stress == trial || stress.isZero(0.))
            continue;
          ++n_yielding;
          EXPECT_NEAR(matsuoka_nakai_ratio(stress) / ratio, 1., 1e-8);
          EXPECT_NEAR(pressure(stress), pressure(trial), 1e-9);
        }
      EXPECT_GT(n_yielding, 20u);
    }
}



TEST(Cones, matsuoka_and_nakai_are_the_same_in_lanes_and_components)
{
  const MatsuokaNakai law(constants_of(YieldCone::matsuoka_nakai, 30., 200.));
  for (unsigned int n = 0; n < 50; ++n)
    {
      const SymmetricComponents<4>  trial  = random_stress<4>();
      SymmetricComponents<4>        stress = trial;
      SymmetricComponents<6>        in_space;
      SymmetricComponents<4, Lanes> lanes;
      in_space << trial, 0., 0.;
      for (int c = 0; c < 4; ++c)
        lanes[c] = Lanes(trial[c]);
      law.project(stress);
      law.project(in_space);
      law.project(lanes);
      for (int c = 0; c < 4; ++c)
        {
          EXPECT_NEAR(lanes[c][2], stress[c], 1e-10);
          EXPECT_NEAR(in_space[c], stress[c], 1e-10);
        }
    }
}



TEST(Cones, projection_derivative_is_that_of_the_return)
{
  const MatsuokaNakai law(constants_of(YieldCone::matsuoka_nakai, 30., 200.));
  for (unsigned int n = 0; n < 50; ++n)
    {
      const SymmetricComponents<6> trial = random_stress<6>();
      if (std::abs(law.yield_function(trial)) < 10. || pressure(trial) < -300.)
        continue;
      const auto derivative = law.projection_derivative(trial);
      for (int c = 0; c < 6; ++c)
        {
          constexpr double       step  = 1e-3;
          SymmetricComponents<6> above = trial, below = trial;
          above[c] += step;
          below[c] -= step;
          law.project(above);
          law.project(below);
          for (int d = 0; d < 6; ++d)
            EXPECT_NEAR(derivative(d, c),
                        (above[d] - below[d]) / (2. * step),
                        1e-5);
        }
    }
}



TEST(Cones, cohesion_is_the_strength_without_pressure)
{
  constexpr double angle = 30. * pi / 180., cohesion = 500.;
  const double     strength =
    2. * cohesion * std::cos(angle) / (1. - std::sin(angle));
  const SymmetricComponents<4> unconfined(0., -strength, 0., 0.);
  const DruckerPrager          circle(
    constants_of(YieldCone::compression, 30., cohesion));
  const MatsuokaNakai smooth(
    constants_of(YieldCone::matsuoka_nakai, 30., cohesion));
  EXPECT_NEAR(circle.yield_function(unconfined) / strength, 0., 1e-12);
  EXPECT_NEAR(smooth.yield_function(unconfined) / strength, 0., 1e-9);

  // In plane flow, tau = c cos(phi) + p sin(phi).
  const DruckerPrager plane_cone(
    constants_of(YieldCone::plane_strain, 30., cohesion));
  const double tau = cohesion * std::cos(angle) + 1000. * std::sin(angle);
  EXPECT_NEAR(plane_cone.yield_function(
                SymmetricComponents<4>(-1000., -1000., -1000., tau)),
              0.,
              1e-9);
}



TEST(Cones, tension_is_cut_off_and_its_density_agrees)
{
  constexpr double angle = 30. * pi / 180., cohesion = 500.;
  const double     apex = cohesion / std::tan(angle);
  for (const YieldCone cone :
       {YieldCone::plane_strain, YieldCone::compression, YieldCone::paper})
    {
      const DruckerPrager    law(constants_of(cone, 30., cohesion));
      SymmetricComponents<4> inside = isotropic<4>(0.999 * apex),
                             beyond = isotropic<4>(1.001 * apex);
      law.project(inside);
      law.project(beyond);
      EXPECT_EQ(inside, isotropic<4>(0.999 * apex));
      EXPECT_TRUE(beyond.isZero(0.));
      EXPECT_NEAR(law.loosest_density_share(),
                  std::exp(-apex / law.elasticity.bulk_modulus()),
                  1e-15);
    }
  // Without friction there is no apex.
  const DruckerPrager    clay(constants_of(YieldCone::paper, 0., cohesion));
  SymmetricComponents<4> inside = isotropic<4>(1.999 * cohesion),
                         beyond = isotropic<4>(2.001 * cohesion);
  clay.project(inside);
  clay.project(beyond);
  EXPECT_FALSE(inside.isZero(0.));
  EXPECT_TRUE(beyond.isZero(0.));
}



TEST(Cones, what_is_no_number_spreads)
{
  const MatsuokaNakai    law(constants_of(YieldCone::matsuoka_nakai, 30.));
  SymmetricComponents<4> stress(-1e3, std::nan(""), -1e3, 0.);
  law.project(stress);
  for (int c = 0; c < 4; ++c)
    EXPECT_TRUE(std::isnan(stress[c]));
  // A deviator of rounding alone is elastic.
  SymmetricComponents<4> rounded(-1e3, -1e3 * (1. + 2e-16), -1e3, 0.);
  law.project(rounded);
  EXPECT_NEAR(rounded[0], -1e3, 1e-9);
  SymmetricComponents<4> none = SymmetricComponents<4>::Zero();
  law.project(none);
  EXPECT_TRUE(none.isZero(0.));
}
