#include <sandglass/continuum/in_plane_response.h>
#include <sandglass/material/drucker_prager.h>

#include <gtest/gtest.h>

#include <cmath>

#include "return_case.h"

using namespace Sandglass;

namespace
{
  constexpr double pi = 3.14159265358979323846;

  // Stress before the increment in all tests of the tangent: with shear, so
  // that it turns.
  const SymmetricComponents<4> initial_stress(-5000., -9000., -6000., 700.);

  /// E = 1 MPa, nu = 0.3, phi = 25 degrees, as in the paper.
  const Elasticity    elasticity(1e6, 0.3);
  const DruckerPrager material(elasticity, 25. * pi / 180.);

  /// The elastic stress after the increment.
  SymmetricComponents<4>
  trial_stress(
    const Elasticity             &elasticity,
    const SymmetricComponents<4> &stress_before,
    const Gradient5              &H,
    const StressIntegration integration = StressIntegration::start_of_step)
  {
    const auto increment = InPlaneResponse::increment(H, integration);
    return rotate(stress_before, increment.rotation) +
           elasticity.stress(increment.strain);
  }



  /// As the static stage finds it, by the law.
  SymmetricComponents<4>
  stress_after(
    const SymmetricComponents<4> &stress_before,
    const Gradient5              &H,
    const StressIntegration integration = StressIntegration::start_of_step)
  {
    const auto increment          = InPlaneResponse::increment(H, integration);
    SymmetricComponents<4> stress = rotate(stress_before, increment.rotation);
    auto                   law_state = material.initial_state();
    material.correct(stress, law_state, material.predict(increment, 0.));
    return stress;
  }



  Gradient5
  piola_stress(const SymmetricComponents<4> &stress_before,
               const Gradient5              &H,
               const StressIntegration       integration)
  {
    return InPlaneResponse::piola_stress(
      stress_after(stress_before, H, integration), H);
  }



  Matrix5
  tangent(
    const SymmetricComponents<4> &stress_before,
    const Gradient5              &H,
    const StressIntegration integration = StressIntegration::start_of_step)
  {
    const ComponentMatrix<4> projection = material.projection_derivative(
      trial_stress(elasticity, stress_before, H, integration));
    return InPlaneResponse::tangent(stress_before,
                                    stress_after(stress_before, H, integration),
                                    H,
                                    {projection,
                                     projection * elasticity.stiffness<4>()},
                                    integration);
  }



  /// Largest difference to central differences, over the confined modulus.
  double
  tangent_error(
    const SymmetricComponents<4> &stress_before,
    const Gradient5              &H,
    const StressIntegration integration = StressIntegration::start_of_step)
  {
    constexpr double step = 1e-6;
    Matrix5          differences;
    for (int i = 0; i < 5; ++i)
      {
        const Gradient5 change = step * Gradient5::Unit(i);
        differences.col(i) =
          (piola_stress(stress_before, H + change, integration) -
           piola_stress(stress_before, H - change, integration)) /
          (2. * step);
      }
    return (tangent(stress_before, H, integration) - differences)
             .lpNorm<Eigen::Infinity>() /
           elasticity.confined_modulus();
  }



  ReturnCase
  case_of_increment(const SymmetricComponents<4> &stress_before,
                    const Gradient5              &H)
  {
    return case_of(trial_stress(elasticity, stress_before, H),
                   stress_after(stress_before, H));
  }



  Gradient5
  gradient(const double xx,
           const double xy,
           const double yx,
           const double yy,
           const double hoop)
  {
    Gradient5 H;
    H << xx, xy, yx, yy, hoop;
    return H;
  }
} // namespace



TEST(IncrementalResponse, TangentAgreesWithDifferencesWhereElastic)
{
  for (const double hoop : {0., -0.001})
    {
      const Gradient5 H = gradient(-0.002, 0.0015, -0.002, -0.003, hoop);
      ASSERT_EQ(case_of_increment(initial_stress, H), ReturnCase::elastic);
      EXPECT_LT(tangent_error(initial_stress, H), 1e-8);
    }
}



TEST(IncrementalResponse, TangentAgreesWithDifferencesWhereYielding)
{
  for (const double hoop : {0., -0.004})
    {
      const Gradient5 H = gradient(0.004, 0.05, -0.03, -0.04, hoop);
      ASSERT_EQ(case_of_increment(initial_stress, H), ReturnCase::yielding);
      EXPECT_LT(tangent_error(initial_stress, H), 1e-8);
    }
}



TEST(IncrementalResponse, TangentAgreesWithDifferencesInTheMiddleOfTheStep)
{
  for (const double hoop : {0., -0.004})
    for (const double size : {1., 0.05, 5.})
      EXPECT_LT(tangent_error(initial_stress,
                              size * gradient(0.004, 0.05, -0.03, -0.04, hoop),
                              StressIntegration::middle_of_step),
                1e-7);
}



TEST(IncrementalResponse, LawsTangentIsItsDerivativeOrElastic)
{
  for (const Gradient5 &H : {gradient(-0.002, 0.0015, -0.002, -0.003, -0.001),
                             gradient(0.004, 0.05, -0.03, -0.04, -0.004)})
    {
      const auto                   increment = InPlaneResponse::increment(H);
      const SymmetricComponents<4> turned =
        rotate(initial_stress, increment.rotation);
      const ComponentMatrix<4> stiffness  = elasticity.stiffness<4>();
      const ComponentMatrix<4> derivative = material.projection_derivative(
        trial_stress(elasticity, initial_stress, H));
      const auto exact =
        material.tangent(turned, material.initial_state(), increment, 0.);
      EXPECT_LT((exact.by_stress - derivative).norm(), 1e-12);
      EXPECT_LT((exact.by_strain - derivative * stiffness).norm(),
                1e-12 * stiffness.norm());
      const auto elastic =
        material.tangent(turned, material.initial_state(), increment, 1.);
      EXPECT_LT((elastic.by_strain - stiffness).norm(),
                1e-12 * stiffness.norm());
    }
}



TEST(IncrementalResponse, TangentAgreesWithDifferencesWhereSeparated)
{
  for (const double hoop : {0., 0.01})
    {
      const Gradient5 H = gradient(0.02, 0.05, -0.03, 0.01, hoop);
      ASSERT_EQ(case_of_increment(initial_stress, H), ReturnCase::separated);
      EXPECT_LT(tangent_error(initial_stress, H), 1e-8);
      EXPECT_EQ(tangent(initial_stress, H), Matrix5::Zero());
    }
}



namespace
{
  /// Gradient of the displacement by a rotation, counterclockwise.
  Gradient5
  rotation(const double angle)
  {
    return gradient(std::cos(angle) - 1.,
                    -std::sin(angle),
                    std::sin(angle),
                    std::cos(angle) - 1.,
                    0.);
  }



  /// How far a rotated stress is from the exact one, over its size.
  double
  rotation_error(const double angle)
  {
    const double                 c = std::cos(angle), s = std::sin(angle);
    const auto                  &a = initial_stress;
    const SymmetricComponents<4> exact(
      c * c * a[0] + s * s * a[1] - 2. * c * s * a[3],
      s * s * a[0] + c * c * a[1] + 2. * c * s * a[3],
      a[2],
      c * s * (a[0] - a[1]) + (c * c - s * s) * a[3]);
    // soft, so that the error of the spin is seen beside that of the strain
    const Elasticity soft(1e4, 0.3);
    return (trial_stress(soft, a, rotation(angle)) - exact).norm() / a.norm();
  }
} // namespace



TEST(IncrementalResponse, TranslationChangesNothing)
{
  const Gradient5 H = Gradient5::Zero();
  EXPECT_EQ(trial_stress(elasticity, initial_stress, H), initial_stress);
  EXPECT_EQ(InPlaneResponse::volume_ratio(H), 1.);
  const Gradient5 P = InPlaneResponse::piola_stress(initial_stress, H);
  EXPECT_EQ(P, gradient(-5000., 700., 700., -9000., -6000.));
}



// The forward-Euler rule isn't objective for finite rotations (Section 4.1):
// its error is of second order in the angle.
TEST(IncrementalResponse, RotationErrorIsOfSecondOrder)
{
  EXPECT_LT(rotation_error(1e-3), 1e-5);
  for (const double angle : {0.02, -0.02})
    EXPECT_NEAR(rotation_error(angle) / rotation_error(angle / 2.), 4., 0.05);
  EXPECT_NEAR(InPlaneResponse::volume_ratio(rotation(0.3)), 1., 1e-15);
}



// The force P N ds of the reference area N ds is the Cauchy stress on the
// rotated area, for an exact rotation.
TEST(IncrementalResponse, PiolaStressTurnsTheArea)
{
  const double    angle = 0.7;
  const Gradient5 P =
    InPlaneResponse::piola_stress({-1000., 0., 0., 0.}, rotation(angle));
  const double normal_x = std::cos(angle); // of the area that was normal to x
  EXPECT_NEAR(P[GradientComponent::xx], -1000. * normal_x, 1e-10);
  EXPECT_NEAR(P[GradientComponent::yx], 0., 1e-10);
  EXPECT_NEAR(P[GradientComponent::xy], 1000. * std::sin(angle), 1e-10);
}
