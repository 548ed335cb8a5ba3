#include <sandglass/study/extrapolation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>
#include <vector>

#include "random_engine.h"

using namespace Sandglass;

namespace
{
  /// The sizes of a convergence study's cells, in units of the middle one.
  const std::vector<double> sizes = {2., 1. / 0.7, 1., 1. / 1.4, 0.5};

  template <typename Value>
  std::vector<double>
  values_of(const Value &value)
  {
    std::vector<double> values;
    for (const double size : sizes)
      values.push_back(value(size));
    return values;
  }
} // namespace



TEST(Extrapolation, FindsALine)
{
  const Extrapolation result =
    extrapolate(sizes, values_of([](const double h) { return 7. - 0.3 * h; }));
  EXPECT_NEAR(result.value, 7., 1e-12);
  EXPECT_NEAR(result.slope, -0.3, 1e-12);
  // No scatter: what is left is the difference from a parabola.
  EXPECT_GT(result.uncertainty, 0.05);
  EXPECT_LT(result.uncertainty, 0.3);
}



TEST(Extrapolation, IsSureOfAConstant)
{
  const Extrapolation result =
    extrapolate(sizes, values_of([](const double) { return 7.; }));
  EXPECT_NEAR(result.value, 7., 1e-12);
  EXPECT_NEAR(result.uncertainty, 0., 1e-12);
}



TEST(Extrapolation, KnowsNothingFromTwo)
{
  const Extrapolation result = extrapolate({1., 0.5}, {3., 4.});
  EXPECT_TRUE(std::isnan(result.value));
  EXPECT_TRUE(std::isnan(result.uncertainty));
}



/// The normal equations for the values 1, 3, 2 on the sizes 1, 2, 3 with the
/// weights 1, 1/4, 1/9, solved in fractions: the line is 2/13 + 25/26 h with
/// the standard error 9/13 sqrt(3) of its intercept, the curve of second order
/// begins at 173/181. Student's t for one degree of freedom is 12.706.
TEST(Extrapolation, IsThatOfTextbooks)
{
  const Extrapolation result = extrapolate({1., 2., 3.}, {1., 3., 2.});
  EXPECT_NEAR(result.value, 2. / 13., 1e-12);
  EXPECT_NEAR(result.slope, 25. / 26., 1e-12);
  EXPECT_NEAR(result.uncertainty,
              std::hypot(12.7062 * 9. / 13. * std::sqrt(3.),
                         173. / 181. - 2. / 13.),
              1e-3);
}



/// With an error of first or of second order and with scatter the true value
/// lies within the uncertainty in some 95 % of all cases, and the uncertainty
/// says something.
TEST(Extrapolation, ContainsTheTruth)
{
  std::mt19937                     random = random_engine();
  std::normal_distribution<double> scatter(0., 0.01);
  constexpr unsigned int           n = 2000;
  for (const double order : {1., 2.})
    for (const double error : {0., -0.05, -0.2})
      {
        unsigned int n_within    = 0;
        double       uncertainty = 0.;
        for (unsigned int i = 0; i < n; ++i)
          {
            const Extrapolation result =
              extrapolate(sizes, values_of([&](const double h) {
                            return 1. + error * std::pow(h, order) +
                                   h * scatter(random);
                          }));
            n_within += std::abs(result.value - 1.) <= result.uncertainty;
            uncertainty += result.uncertainty / n;
          }
        std::cout << "order " << order << ", error " << error << ": "
                  << 100. * n_within / n << " % within " << uncertainty
                  << std::endl;
        EXPECT_GT(n_within, 0.93 * n);
        EXPECT_LT(uncertainty, 0.05 + 2. * std::abs(error));
      }
}
