#include "../footing.h"

#include <gtest/gtest.h>

using namespace Sandglass;

namespace
{
  constexpr unsigned int n_cells = 4; // in the footing's half width

  class FootingTest : public testing::TestWithParam<Footing::Cells>
  {};
} // namespace



// The limits found are 0.96 for triangles and 0.93 for quadrilaterals
// (doc/verification.md).
TEST_P(FootingTest, FailsAtPrandtlsPressureWithAveragedVolumetricStrain)
{
  EXPECT_TRUE(
    Footing(GetParam(), VolumetricStrain::averaged, n_cells).carries(0.85));
  EXPECT_FALSE(
    Footing(GetParam(), VolumetricStrain::averaged, n_cells).carries(1.05));
}

INSTANTIATE_TEST_SUITE_P(Cells,
                         FootingTest,
                         testing::Values(Footing::Cells::alternating_triangles,
                                         Footing::Cells::parallel_triangles,
                                         Footing::Cells::quadrilaterals));



// What the averaging is for: without it linear triangles carry 1.15 times the
// limit.
TEST(Footing, LocksOnParallelTrianglesWithTheElementsVolumetricStrain)
{
  EXPECT_TRUE(Footing(Footing::Cells::parallel_triangles,
                      VolumetricStrain::element,
                      n_cells)
                .carries(1.1));
}
