#include <sandglass/base/compensated_sum.h>

#include <gtest/gtest.h>

#include <cmath>

using Sandglass::CompensatedSum;

// A million times a number that the sum can't hold exactly.
TEST(CompensatedSum, IsExact)
{
  CompensatedSum sum;
  double         plain = 0.;
  for (unsigned int i = 0; i < 1000000; ++i)
    {
      sum += 0.1;
      plain += 0.1;
    }
  EXPECT_DOUBLE_EQ(sum, 1e5);
  EXPECT_GT(std::abs(plain - 1e5), 1e-7);
}



// Sums of sums lose nothing either.
TEST(CompensatedSum, AddsSums)
{
  CompensatedSum large, small;
  large += 1e10;
  for (unsigned int i = 0; i < 1000; ++i)
    {
      large += 1e-8;
      small += 1e-8;
    }
  large += small;
  EXPECT_DOUBLE_EQ(static_cast<double>(large) - 1e10, (1e10 + 2e-5) - 1e10);
}
