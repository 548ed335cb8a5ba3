// exp, log and pow of Lanes: as accurate as said, the same for a lane and for a
// double, and sound at the ends of the range.

#include <sandglass/base/instruction_sets.h>
#include <sandglass/base/lanes_functions.h>

#include <gtest/gtest.h>

#include <vector>

#include "../random_engine.h"

using namespace Sandglass;

namespace
{
  constexpr double infinity     = std::numeric_limits<double>::infinity();
  constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

  double
  relative_difference(const double a, const double b)
  {
    return a == b ? 0. : std::abs(a - b) / std::abs(b);
  }

  Lanes
  lanes(const double *const numbers)
  {
    alignas(Lanes) double aligned[Lanes::n];
    std::copy(numbers, numbers + Lanes::n, aligned);
    return Lanes::load(aligned);
  }

  /// Bits, so that numbers that are none compare as well.
  bool
  are_same(const double a, const double b)
  {
    return LanesFunctions::bits_of(a) == LanesFunctions::bits_of(b);
  }
} // namespace



TEST(LanesFunctions, exponential)
{
  auto                                   engine = random_engine();
  std::uniform_real_distribution<double> any(-708., 709.), small(-1., 1.);
  for (unsigned int i = 0; i < 100000; ++i)
    for (const double x : {any(engine), small(engine), 1e-6 * small(engine)})
      ASSERT_LT(relative_difference(exponential(x), std::exp(x)), 1e-13) << x;
  for (const double x : {0., -0., 1., -708., 709., 1e-300, 0.5 * std::log(2.)})
    EXPECT_LT(relative_difference(exponential(x), std::exp(x)), 1e-13) << x;
  for (const double x : {710., 1e5, 1e300, infinity})
    EXPECT_EQ(exponential(x), infinity);
  for (const double x : {-750., -1e5, -1e300, -infinity})
    EXPECT_EQ(exponential(x), 0.);
  EXPECT_EQ(exponential(0.), 1.);
  EXPECT_TRUE(std::isnan(exponential(not_a_number)));
}



TEST(LanesFunctions, logarithm)
{
  auto                                   engine = random_engine(2);
  std::uniform_real_distribution<double> any(-708., 709.), small(-1., 1.);
  for (unsigned int i = 0; i < 100000; ++i)
    for (const double x : {std::exp(any(engine)),
                           std::exp(small(engine)),
                           1. + 1e-6 * small(engine)})
      ASSERT_LT(relative_difference(logarithm(x), std::log(x)), 1e-13) << x;
  using Limits = std::numeric_limits<double>;
  for (const double x : {1., 2., 0.5, std::sqrt(0.5), std::sqrt(2.), 10.})
    EXPECT_LT(relative_difference(logarithm(x), std::log(x)), 1e-13) << x;
  for (const double x : {Limits::min(), Limits::max(), 1. + Limits::epsilon()})
    EXPECT_LT(relative_difference(logarithm(x), std::log(x)), 1e-13) << x;
  EXPECT_EQ(logarithm(1.), 0.);
  EXPECT_EQ(logarithm(0.), -infinity);
  EXPECT_EQ(logarithm(infinity), infinity);
  EXPECT_TRUE(std::isnan(logarithm(-1.)));
  EXPECT_TRUE(std::isnan(logarithm(not_a_number)));
}



// The relative error of a power is that of y log(x), absolute.
TEST(LanesFunctions, power)
{
  auto                                   engine = random_engine(3);
  std::uniform_real_distribution<double> exponent(-4., 4.), log_of_x(-30., 30.);
  for (unsigned int i = 0; i < 100000; ++i)
    {
      const double y = exponent(engine);
      const double x = std::exp(log_of_x(engine));
      ASSERT_LT(relative_difference(power(x, y), std::pow(x, y)),
                1e-13 * (1. + std::abs(y * std::log(x))))
        << x << " to the power " << y;
    }
  EXPECT_EQ(power(0., 0.14), 0.);
  EXPECT_EQ(power(0., -1.), infinity);
}



// Four lanes, with the widest vectors that the processor has and without.
TEST(LanesFunctions, lanes_are_doubles)
{
  auto                                   engine = random_engine(4);
  std::uniform_real_distribution<double> any(-800., 800.), positive(0., 1e4);

  std::vector<double> numbers = {0.,
                                 -0.,
                                 infinity,
                                 -infinity,
                                 not_a_number,
                                 1.,
                                 -1.,
                                 1e300,
                                 -1e300,
                                 1e-300,
                                 710.};
  while (numbers.size() < 4000)
    {
      numbers.push_back(any(engine));
      numbers.push_back(positive(engine));
    }
  numbers.resize(4000);

  const auto compare = [&numbers]() {
    for (unsigned int i = 0; i < numbers.size(); i += Lanes::n)
      {
        const Lanes x     = lanes(&numbers[i]);
        const Lanes exps  = exponential(x);
        const Lanes logs  = logarithm(x);
        const Lanes roots = power(x, Lanes(0.27));
        for (unsigned int lane = 0; lane < Lanes::n; ++lane)
          {
            const double number = numbers[i + lane];
            ASSERT_TRUE(are_same(exps[lane], exponential(number))) << number;
            if (number >= 0.)
              {
                ASSERT_TRUE(are_same(logs[lane], logarithm(number))) << number;
                ASSERT_TRUE(are_same(roots[lane], power(number, 0.27)))
                  << number;
              }
            else
              ASSERT_EQ(std::isnan(logs[lane]), std::isnan(logarithm(number)));
          }
      }
  };
  compare();
  run_with_widest_vectors(compare);
}
