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

// Material that flies up to where the grid ends stays in it, and falls down
// again; before, a particle that did stopped the run.
TEST_P(FreeFall, IsHeldAtTheTopOfTheGrid)
{
  StageFixture fixture;
  fixture.formulation               = std::get<1>(GetParam());
  fixture.parameters.time_step_text = "1e-3";
  Rectangle rectangle;
  rectangle.cell_type = std::get<0>(GetParam());
  rectangle.upper     = Point<2>(0.5, 1.);
  rectangle.n_x       = 5;
  rectangle.n_y       = 10;
  rectangle.is_filled = [](const Point<2> &center) {
    return center[1] > 0.5 && center[1] < 0.9;
  };
  const auto throw_up = [&fixture, &rectangle ]() -> auto &
  {
    auto &stage = fixture.start(rectangle.mesh());
    fixture.change_particles([](auto, const auto &, auto state) {
      state[StageLayout::velocity + 1] = 2.;
    });
    return stage;
  };
  auto        &stage  = throw_up();
  const double mass   = stage.view().totals().mass_in_silo;
  double       height = 0.;
  for (unsigned int step = 0; step < 400; ++step)
    {
      stage.step();
      height = 0.;
      fixture.for_each_particle([&](auto, const auto &position, auto) {
        EXPECT_LT(position[1], 1.);
        height = std::max(height, position[1]);
      });
    }
  EXPECT_LT(height, 0.9);
  EXPECT_NEAR(stage.view().totals().mass_in_silo / mass, 1., 1e-14);

  fixture.parameters.on_lost_particle =
    ParticleStageParameters::OnLostParticle::stop;
  auto &stopping = throw_up();
  EXPECT_THROW(
    {
      for (unsigned int step = 0; step < 400; ++step)
        stopping.step();
    },
    RunError);
}

INSTANTIATE_TEST_SUITE_P(
  Settings,
  FreeFall,
  testing::Combine(testing::Values(CellType::triangle, CellType::quadrilateral),
                   testing::Values(Formulation::plane_strain,
                                   Formulation::axisymmetric)));
