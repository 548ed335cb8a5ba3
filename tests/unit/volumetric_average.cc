#include <sandglass/continuum/plane_strain.h>
#include <sandglass/flow/particle_in_cell/volumetric_average.h>

#include <gtest/gtest.h>

#include <cmath>

#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  using Triangles = Setting<PlaneStrain, CellType::triangle>;

  /// A square of 4 x 4 squares of two triangles each.
  class VolumetricAverageTest : public testing::Test
  {
  protected:
    VolumetricAverageTest()
      : stage(fixture.start(Rectangle().mesh()))
      , geometry(*fixture.scene)
      , sums(geometry, 0.9 * fixture.material.density, {})
      , average(*fixture.scene->nodes,
                geometry,
                0.9 * fixture.material.density,
                true)
    {}

    /// Average for the velocity of a function of the position.
    template <typename Function>
    void
    compute(const Function &velocity)
    {
      sums.cells.compute(stage.particles().blocks());
      average.compute(stage.particles().blocks(),
                      sums,
                      fixture.at_nodes(velocity));
    }

    StageFixture                     fixture;
    StageFixture::Stage             &stage;
    CellGeometry<CellType::triangle> geometry;
    NodalSums<Triangles>             sums;
    VolumetricAverage<Triangles>     average;
  };
} // namespace



TEST_F(VolumetricAverageTest, OfAUniformRateIsThatRate)
{
  compute([](const Point<2> &p) {
    return Tensor<1, 2>({0.3 * p[0] + p[1], -0.1 * p[1]});
  });
  for (const auto &cell : stage.particles().owned_cells())
    EXPECT_NEAR(average.rate(cell->active_cell_index()) / 0.2, 1., 1e-13);
}



// A column of squares whose inner nodes move up and down in turn: each
// triangle's rate is far from 0, the averages inside are much smaller.
TEST_F(VolumetricAverageTest, SmoothsAnAlternatingRate)
{
  compute([](const Point<2> &p) {
    const int column = std::lround(4. * p[0]), row = std::lround(4. * p[1]);
    return Tensor<1, 2>({0., (column + row) % 2 == 0 ? 1. : -1.});
  });
  double largest = 0.;
  for (const auto &cell : stage.particles().owned_cells())
    largest =
      std::max(largest, std::abs(average.rate(cell->active_cell_index())));
  // In each triangle the rate is 2 / h = 8 or 0.
  EXPECT_LT(largest / 8., 0.51);
}



// What separated particles do doesn't reach dense ones.
TEST_F(VolumetricAverageTest, LeavesSeparatedParticlesOut)
{
  fixture.change_particles([&](auto, const auto &position, auto state) {
    if (position[0] > 0.5)
      state[StageLayout::density] = 0.5 * fixture.material.density;
  });
  compute([](const Point<2> &p) {
    return Tensor<1, 2>({p[0] > 0.5 ? 10. * (p[0] - 0.5) : 0., 0.1 * p[1]});
  });
  for (const auto &cell : stage.particles().owned_cells())
    if (cell->center()[0] < 0.5)
      {
        EXPECT_NEAR(average.rate(cell->active_cell_index()) / 0.1, 1., 1e-13);
      }
}
