#include <gtest/gtest.h>

#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  /// A box of cells 0.1 m large; steps of 1 ms.
  class FreeFall
    : public testing::TestWithParam<std::tuple<CellType, Formulation>>
  {
  protected:
    FreeFall()
    {
      fixture.formulation               = std::get<1>(GetParam());
      fixture.parameters.time_step_text = "1e-3";
      rectangle.cell_type               = std::get<0>(GetParam());
    }

    /// The stage of such a box, 0.5 m wide and some cells high, filled in part.
    template <typename IsFilled>
    auto &
    start(const unsigned int n_y, const IsFilled &is_filled)
    {
      rectangle.upper     = Point<2>(0.5, 0.1 * n_y);
      rectangle.n_x       = 5;
      rectangle.n_y       = n_y;
      rectangle.is_filled = is_filled;
      return fixture.start(rectangle.mesh());
    }

    StageFixture fixture;
    Rectangle    rectangle;
  };
} // namespace

TEST_P(FreeFall, IsExactAndStressFree)
{
  auto &stage =
    start(20, [](const Point<2> &center) { return center[1] > 1.5; });

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
  const auto throw_up = [this]() -> auto &
  {
    auto &stage = start(10, [](const Point<2> &center) {
      return center[1] > 0.5 && center[1] < 0.9;
    });
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
