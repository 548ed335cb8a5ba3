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
        const ForceIntegration integration,
        const unsigned int     n_cells)
  {
    const auto carries = [&](const double load) {
      return Footing(cells, volumetric_strain, n_cells, integration)
        .carries(load);
    };
    double carried = 0.5, failed = 1.5;
    EXPECT_TRUE(carries(carried));
    EXPECT_FALSE(carries(failed));
    while (failed - carried > 0.02)
      {
        const double middle                  = (carried + failed) / 2.;
        (carries(middle) ? carried : failed) = middle;
      }
    const double result  = (carried + failed) / 2.;
    const char  *names[] = {"triangles, diagonals alternate",
                            "triangles, diagonals parallel",
                            "quadrilaterals"};
    std::cout << names[static_cast<unsigned int>(cells)] << ", "
              << (volumetric_strain == VolumetricStrain::averaged ? "averaged" :
                                                                    "element")
              << ", " << name_of(integration) << ", " << n_cells
              << " cells: limit / exact " << result << std::endl;
    return result;
  }
} // namespace



// With the averaged strain and the paper's integration the limit is 4 to 7 %
// low on both meshes; with the cells' integration 4 %, for quadrilaterals as
// for triangles: flow that keeps the volume, the load that is not quite static,
// and a footing of four cells. With the element's strain it comes down as the
// mesh is refined.
TEST_P(FootingLimit, IsNearPrandtlsExceptWhereCellsLock)
{
  const auto [cells, volumetric_strain] = GetParam();
  const double coarse =
    limit(cells, volumetric_strain, ForceIntegration::particles, 4);
  const double fine =
    limit(cells, volumetric_strain, ForceIntegration::particles, 8);
  const double of_cell =
    limit(cells, volumetric_strain, ForceIntegration::cell, 4);

  const bool locks = cells == Footing::Cells::parallel_triangles &&
                     volumetric_strain == VolumetricStrain::element;
  if (locks)
    {
      EXPECT_GT(coarse, 1.1);
      EXPECT_GT(of_cell, 1.1);
      EXPECT_LT(fine, coarse - 0.05);
    }
  else
    {
      EXPECT_NEAR(coarse, 1., 0.1);
      EXPECT_NEAR(fine, 1., 0.1);
      EXPECT_NEAR(of_cell, 1., 0.05);
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
