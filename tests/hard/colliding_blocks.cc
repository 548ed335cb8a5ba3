#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  constexpr double h     = 0.1; // m
  constexpr double speed = 0.5; // m/s

  /// Two blocks of 8 cells that meet and are thrown back.
  struct Blocks
  {
    Blocks(const CellType cell_type, const DensityUpdate density_update)
    {
      fixture.gravity                          = {};
      fixture.material.internal_friction_angle = 40.;
      fixture.parameters.end_time              = 1e3;
      fixture.parameters.density_update        = density_update;
      Rectangle rectangle;
      rectangle.cell_type = cell_type;
      rectangle.n_x       = 40;
      rectangle.n_y       = 4;
      rectangle.upper     = Point<2>(40 * h, 4 * h);
      rectangle.left      = BoundaryRole::wall;
      // Smooth: uniaxial strain, elastic while it is compressed
      rectangle.bottom = rectangle.top = BoundaryRole::axis;
      rectangle.is_filled              = [](const Point<2> &center) {
        const double distance = std::abs(center[0] - 20 * h);
        return distance > h && distance < 9 * h;
      };
      fixture.start(rectangle.mesh());
      fixture.change_particles([&](auto id, auto &, auto state) {
        state[StageLayout::velocity] = is_left(id) ? speed : -speed;
      });
    }

    bool
    is_left(const types::particle_index id) const
    {
      return fixture.stage->initial_position(id)[0] < 20 * h;
    }

    struct Block
    {
      double mass = 0., momentum = 0., first = 1e300, last = -1e300;

      double
      velocity() const
      {
        return momentum / mass;
      }
    };

    /// The left one and the right one.
    std::array<Block, 2>
    blocks() const
    {
      std::array<Block, 2> result;
      fixture.for_each_particle([&](auto id, const auto &position, auto state) {
        Block &block = result[is_left(id) ? 0 : 1];
        block.mass += state[StageLayout::mass];
        block.momentum +=
          state[StageLayout::mass] * state[StageLayout::velocity];
        block.first = std::min(block.first, position[0]);
        block.last  = std::max(block.last, position[0]);
      });
      return result;
    }

    StageFixture fixture;
  };

  class CollidingBlocks
    : public testing::TestWithParam<std::tuple<CellType, DensityUpdate>>
  {};
} // namespace



// The blocks feel each other at a distance of two cells, as they share nodes.
// With particles that take the grid's velocity in step 6 instead of its change,
// squares come apart 1.1 to 1.4 times as fast as they met. Momentum is off by
// 0.7 once a block reaches the end of the grid.
TEST_P(CollidingBlocks, KeepMomentumAndComeApartAgain)
{
  Blocks       scene(std::get<0>(GetParam()), std::get<1>(GetParam()));
  auto        &stage    = *scene.fixture.stage;
  const auto   before   = scene.blocks();
  const double scale    = before[0].mass * speed;
  const double momentum = before[0].momentum + before[1].momentum;

  double momentum_error = 0., smallest_gap = 1e300, gap = 0.;
  while (stage.view().clock().time < 1.)
    {
      stage.step();
      const auto [left, right] = scene.blocks();
      momentum_error =
        std::max(momentum_error,
                 std::abs(left.momentum + right.momentum - momentum) / scale);
      gap          = right.first - left.last;
      smallest_gap = std::min(smallest_gap, gap);
    }
  const auto   after = scene.blocks();
  const double restitution =
    (after[1].momentum - after[0].momentum) / scale / 2;
  while (stage.view().clock().time < 1.4)
    stage.step();
  const auto   last  = scene.blocks();
  const double later = last[1].first - last[0].last;

  std::cout << "momentum error / (m v)      " << momentum_error
            << "\nsmallest gap / cell         " << smallest_gap / h
            << "\nrelative speed after/before " << restitution
            << "\ngap at 1 s / cell           " << gap / h
            << "\ngap at 1.4 s / cell         " << later / h << std::endl;
  EXPECT_LT(momentum_error, 1e-12);
  EXPECT_GT(smallest_gap, -h);
  EXPECT_GT(restitution, 0.9);
  EXPECT_LT(restitution, 1.02);
  EXPECT_GT(gap, h);
  EXPECT_GT(later, gap);
  EXPECT_NEAR((last[0].momentum - after[0].momentum) / scale, 0., 1e-12);
}

INSTANTIATE_TEST_SUITE_P(
  Settings,
  CollidingBlocks,
  testing::Combine(testing::Values(CellType::triangle, CellType::quadrilateral),
                   testing::Values(DensityUpdate::separation,
                                   DensityUpdate::paper)));
