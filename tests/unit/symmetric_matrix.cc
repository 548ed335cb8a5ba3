#include <sandglass/base/symmetric_matrix.h>

#include <gtest/gtest.h>

#include <cmath>

#include "random_engine.h"

using namespace Sandglass;

namespace
{
  /// Largest error of a product with random numbers, beside a loop over all
  /// entries.
  template <unsigned int n>
  double
  largest_error()
  {
    std::mt19937                           engine = random_engine();
    std::uniform_real_distribution<double> uniform(-1., 1.);

    SymmetricMatrix<n>                   matrix;
    std::array<std::array<double, n>, n> entries;
    std::array<double, n>                vector, product;
    for (unsigned int i = 0; i < n; ++i)
      {
        vector[i] = uniform(engine);
        for (unsigned int j = i; j < n; ++j)
          {
            entries[i][j] = entries[j][i] = uniform(engine);
            matrix.set(i, j, entries[i][j]);
          }
      }
    matrix.multiply(vector.data(), product.data());

    double largest = 0.;
    for (unsigned int i = 0; i < n; ++i)
      {
        for (unsigned int j = 0; j < n; ++j)
          product[i] -= entries[i][j] * vector[j];
        largest = std::max(largest, std::abs(product[i]));
      }
    return largest;
  }
} // namespace

// 6, 8 and 24 are what cells have; 6 and 7 do not fill the last tile.
TEST(SymmetricMatrix, TimesAVectorIsWhatAFullMatrixGives)
{
  EXPECT_LT(largest_error<6>(), 1e-14);
  EXPECT_LT(largest_error<7>(), 1e-14);
  EXPECT_LT(largest_error<8>(), 1e-14);
  EXPECT_LT(largest_error<24>(), 1e-13);
}
