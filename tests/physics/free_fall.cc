#include <gtest/gtest.h>

#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  class FreeFall
    : public testing::TestWithParam<std::tuple<CellType, Formulation>>
  {};
} // namespace

TEST_P(FreeFall, IsExactAndStressFree)
{
  StageFixture fixture;
  fixture.formulation               = std::get<1>(GetParam());
  fixture.parameters.time_step_text = "1e-3";
  Rectangle rectangle;
  rectangle.cell_type = std::get<0>(GetParam());
  rectangle.upper     = Point<2>(0.5, 2.);
  rectangle.n_x       = 5;
  rectangle.n_y       = 20;
  rectangle.is_filled = [](const Point<2> &center) { return center[1] > 1.5; };
  auto &stage         = fixture.start(rectangle.mesh());

  constexpr unsigned int n_steps = 400;
  for (unsigned int step = 0; step < n_steps; ++step)
    stage.step();

  // Velocity and position of the symplectic Euler scheme, without error.
  const double time     = n_steps * 1e-3;
  const double velocity = -9.81 * time;
  const double fall     = 9.81 * 1e-6 * n_steps * (n_steps + 1) / 2.;
  fixture.for_each_particle([&](auto id, const auto &position, auto state) {
    const Point<2> start = stage.initial_position(id);
    EXPECT_NEAR(position[0], start[0], 1e-12);
    EXPECT_NEAR(position[1], start[1] - fall, 1e-12);
    EXPECT_NEAR(state[StageLayout::velocity + 1] / velocity, 1., 1e-12);
    for (unsigned int c = 0; c < 4; ++c)
      EXPECT_NEAR(state[StageLayout::stress + c] / (1500. * 9.81), 0., 1e-8);
  });
}

INSTANTIATE_TEST_SUITE_P(
  Settings,
  FreeFall,
  testing::Combine(testing::Values(CellType::triangle, CellType::quadrilateral),
                   testing::Values(Formulation::plane_strain,
                                   Formulation::axisymmetric)));
