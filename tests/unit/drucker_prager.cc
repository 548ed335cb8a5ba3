#include <sandglass/material/circular_cone.h>
#include <sandglass/material/drucker_prager.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <vector>

#include "return_case.h"

using namespace Sandglass;

namespace
{
  constexpr double pi = 3.14159265358979323846;

  const Elasticity elasticity(1e6, 0.3);

  /// sin(phi) = 0.6 makes the slope a round number:
  /// m = 18 * 0.6 / (9 - 0.36) = 10.8 / 8.64 = 1.25
  const DruckerPrager material(elasticity, std::asin(0.6));

  struct Projected
  {
    SymmetricComponents<4> stress;
    ReturnCase             found;
    double                 dissipation;
  };

  Projected
  project(const SymmetricComponents<4> &trial)
  {
    Projected result{trial, ReturnCase::elastic, 0.};
    result.dissipation = material.project(result.stress);
    result.found       = case_of(trial, result.stress);
    return result;
  }

  void
  expect_near(const SymmetricComponents<4> &actual,
              const SymmetricComponents<4> &expected,
              const double                  scale)
  {
    for (int c = 0; c < 4; ++c)
      EXPECT_NEAR(actual[c] / scale, expected[c] / scale, 1e-14) << c;
  }
} // namespace



TEST(DruckerPrager, SlopeOfTheYieldSurface)
{
  EXPECT_NEAR(material.cone.slope, 1.25, 1e-15);
  // phi = 25 degrees: 18 * 0.4226182617 / (9 - 0.1786061952)
  EXPECT_NEAR(CircularCone(YieldCone::paper, 25. * pi / 180., 0.).slope,
              0.8623499732,
              1e-10);
}



TEST(DruckerPrager, KeepsAdmissibleStress)
{
  // p = 1000, s = (-200, 200, 0, 100): s:s = 80000 + 20000, q^2 = 150000;
  // q = 387 < 1250
  const SymmetricComponents<4> trial(-1200., -800., -1000., 100.);
  const Projected              result = project(trial);
  EXPECT_EQ(result.found, ReturnCase::elastic);
  EXPECT_EQ(result.stress, trial);
  EXPECT_EQ(result.dissipation, 0.);
}



TEST(DruckerPrager, ScalesTheDeviatorBack)
{
  // p = 1000, s = (-1000, 1000, 0, 1000): s:s = 2e6 + 2e6, q^2 = 6e6;
  // the deviator shrinks by r = 1250 / sqrt(6e6)
  const double                 r = 1250. / std::sqrt(6e6);
  const SymmetricComponents<4> trial(-2000., 0., -1000., 1000.);
  const Projected              result = project(trial);
  EXPECT_EQ(result.found, ReturnCase::yielding);
  expect_near(result.stress,
              {-1000. - 1000. * r, -1000. + 1000. * r, -1000., 1000. * r},
              1000.);
  EXPECT_NEAR(material.yield_function(result.stress) / 1250., 0., 1e-14);

  // stress : plastic strain = r s : (1 - r) s / (2 G), G = 1e6 / 2.6
  const double work = r * (1. - r) * 4e6 / (2. * 1e6 / 2.6);
  EXPECT_NEAR(result.dissipation / work, 1., 1e-14);
}



TEST(DruckerPrager, DropsStressOfSeparatedMaterial)
{
  // p = -100
  const Projected pulled = project({500., -300., 100., 40.});
  EXPECT_EQ(pulled.found, ReturnCase::separated);
  EXPECT_EQ(pulled.stress,
            SymmetricComponents<4>(SymmetricComponents<4>::Zero()));
  EXPECT_EQ(pulled.dissipation, 0.);
  // p = 0 with shear is outside of the surface as well
  EXPECT_EQ(project({0., 0., 0., 1.}).found, ReturnCase::separated);
  // no stress at all is admissible
  EXPECT_EQ(project({0., 0., 0., 0.}).found, ReturnCase::elastic);
}



TEST(DruckerPrager, DerivativeAgreesWithDifferences)
{
  const std::vector<std::pair<SymmetricComponents<4>, ReturnCase>> cases = {
    {{-1200., -800., -1000., 100.}, ReturnCase::elastic},
    {{-2000., 0., -1000., 1000.}, ReturnCase::yielding},
    {{-300., -4000., -700., -900.}, ReturnCase::yielding},
    {{500., -300., 100., 40.}, ReturnCase::separated}};
  for (const auto &[trial, expected_case] : cases)
    {
      ASSERT_EQ(project(trial).found, expected_case);
      constexpr double step = 1e-2; // Pa
      Eigen::Matrix4d  differences;
      for (int c = 0; c < 4; ++c)
        {
          const SymmetricComponents<4> change =
            step * SymmetricComponents<4>::Unit(c);
          differences.col(c) =
            (project(trial + change).stress - project(trial - change).stress) /
            (2. * step);
        }
      const double error = (material.projection_derivative(trial) - differences)
                             .lpNorm<Eigen::Infinity>();
      std::cout << "largest difference of the derivative " << error
                << std::endl;
      EXPECT_LT(error, 1e-9);
    }
}
