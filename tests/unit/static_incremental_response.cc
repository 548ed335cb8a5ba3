#include <sandglass/static_stage/incremental_response.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace Sandglass;

namespace
{
  constexpr double pi = 3.14159265358979323846;

  /// E = 1 MPa, nu = 0.3, phi = 25 degrees, as in the paper.
  const Elasticity    elasticity(1e6, 0.3);
  const DruckerPrager material(elasticity, 25. * pi / 180.);

  Gradient5
  piola_stress(const SymmetricTensor4 &stress_before, const Gradient5 &H)
  {
    SymmetricTensor4 stress =
      IncrementalResponse::trial_stress(elasticity, stress_before, H);
    double dissipation = 0.;
    material.project(stress, dissipation);
    return IncrementalResponse::piola_stress(stress, H);
  }



  Matrix5
  tangent(const SymmetricTensor4 &stress_before, const Gradient5 &H)
  {
    const SymmetricTensor4 trial =
      IncrementalResponse::trial_stress(elasticity, stress_before, H);
    SymmetricTensor4 stress      = trial;
    double           dissipation = 0.;
    material.project(stress, dissipation);
    return IncrementalResponse::tangent(elasticity,
                                        stress_before,
                                        stress,
                                        H,
                                        material.projection_derivative(trial));
  }



  /// Largest difference to central differences, over the confined modulus.
  double
  tangent_error(const SymmetricTensor4 &stress_before, const Gradient5 &H)
  {
    constexpr double step = 1e-6;
    Matrix5          differences;
    for (int i = 0; i < 5; ++i)
      {
        const Gradient5 change = step * Gradient5::Unit(i);
        differences.col(i)     = (piola_stress(stress_before, H + change) -
                              piola_stress(stress_before, H - change)) /
                             (2. * step);
      }
    return (tangent(stress_before, H) - differences)
             .lpNorm<Eigen::Infinity>() /
           elasticity.confined_modulus();
  }



  DruckerPrager::Case
  case_of(const SymmetricTensor4 &stress_before, const Gradient5 &H)
  {
    SymmetricTensor4 stress =
      IncrementalResponse::trial_stress(elasticity, stress_before, H);
    double dissipation = 0.;
    return material.project(stress, dissipation);
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



// With rotation, initial stress and hoop strain throughout.
const SymmetricTensor4 initial_stress(-5000., -9000., -6000., 700.);

TEST(IncrementalResponse, TangentAgreesWithDifferencesWhereElastic)
{
  for (const double hoop : {0., -0.001})
    {
      const Gradient5 H = gradient(-0.002, 0.0015, -0.002, -0.003, hoop);
      ASSERT_EQ(case_of(initial_stress, H), DruckerPrager::Case::elastic);
      EXPECT_LT(tangent_error(initial_stress, H), 1e-8);
    }
}



TEST(IncrementalResponse, TangentAgreesWithDifferencesWhereYielding)
{
  for (const double hoop : {0., -0.004})
    {
      const Gradient5 H = gradient(0.004, 0.05, -0.03, -0.04, hoop);
      ASSERT_EQ(case_of(initial_stress, H), DruckerPrager::Case::yielding);
      EXPECT_LT(tangent_error(initial_stress, H), 1e-8);
    }
}



TEST(IncrementalResponse, TangentAgreesWithDifferencesWhereSeparated)
{
  for (const double hoop : {0., 0.01})
    {
      const Gradient5 H = gradient(0.02, 0.05, -0.03, 0.01, hoop);
      ASSERT_EQ(case_of(initial_stress, H), DruckerPrager::Case::separated);
      EXPECT_LT(tangent_error(initial_stress, H), 1e-8);
      EXPECT_EQ(tangent(initial_stress, H), Matrix5::Zero());
    }
}
