#include "../footing.h"

#include <gtest/gtest.h>

#include <iostream>

using namespace Sandglass;

namespace
{
  class FootingLimit : public testing::TestWithParam<
                         std::tuple<Footing::Cells, VolumetricStrain>>
  {};

  /// Load beside the surcharge at which the footing fails, over the exact one.
  double
  limit(const Footing::Cells   cells,
        const VolumetricStrain volumetric_strain,
        const unsigned int     n_cells)
  {
    double carried = 0.5, failed = 1.5;
    EXPECT_TRUE(Footing(cells, volumetric_strain, n_cells).carries(carried));
    EXPECT_FALSE(Footing(cells, volumetric_strain, n_cells).carries(failed));
    while (failed - carried > 0.02)
      {
        const double middle = (carried + failed) / 2.;
        (Footing(cells, volumetric_strain, n_cells).carries(middle) ? carried :
                                                                      failed) =
          middle;
      }
    return (carried + failed) / 2.;
  }
} // namespace



// With the averaged strain the limit is 4 to 7 % low on both meshes: flow that
// keeps the volume, the load that is not quite static, and a footing of four or
// eight cells. With the element's it comes down as the mesh is refined.
TEST_P(FootingLimit, IsNearPrandtlsExceptWhereCellsLock)
{
  const auto [cells, volumetric_strain] = GetParam();
  const char  *names[]                  = {"triangles, diagonals alternate",
                                           "triangles, diagonals parallel",
                                           "quadrilaterals"};
  const double coarse                   = limit(cells, volumetric_strain, 4);
  const double fine                     = limit(cells, volumetric_strain, 8);
  std::cout << names[static_cast<unsigned int>(cells)] << ", "
            << (volumetric_strain == VolumetricStrain::averaged ? "averaged" :
                                                                  "element")
            << ": limit / exact " << coarse << " with 4 cells, " << fine
            << " with 8" << std::endl;

  const bool locks = cells == Footing::Cells::parallel_triangles &&
                     volumetric_strain == VolumetricStrain::element;
  if (locks)
    {
      EXPECT_GT(coarse, 1.1);
      EXPECT_LT(fine, coarse - 0.05);
    }
  else
    {
      EXPECT_NEAR(coarse, 1., 0.1);
      EXPECT_NEAR(fine, 1., 0.1);
    }
}

INSTANTIATE_TEST_SUITE_P(
  Settings,
  FootingLimit,
  testing::Combine(testing::Values(Footing::Cells::alternating_triangles,
                                   Footing::Cells::parallel_triangles,
                                   Footing::Cells::quadrilaterals),
                   testing::Values(VolumetricStrain::averaged,
                                   VolumetricStrain::element)));
