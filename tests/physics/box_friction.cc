// Friction of the front and the back of a box.

#include <gtest/gtest.h>

#include <cmath>

#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  constexpr double depth = 0.05, angle = 20., mean_pressure = 3e3;

  /// A square full of material under pressure, without gravity, that moves
  /// along.
  class BoxFrictionTest : public testing::TestWithParam<CellType>
  {
  protected:
    void
    start(const double speed, const double time_step)
    {
      fixture.walls.box_depth          = depth;
      fixture.walls.box_friction_angle = angle;
      fixture.gravity                  = dealii::Tensor<1, 2>();
      fixture.parameters.end_time      = 1.;
      fixture.set_time_step(time_step);
      Rectangle rectangle;
      rectangle.n_x = rectangle.n_y = 8;
      rectangle.cell_type           = GetParam();
      fixture.start(rectangle.mesh());
      fixture.change_particles([&](auto, const auto &, auto properties) {
        for (int c = 0; c < 3; ++c)
          properties[StageLayout::stress + c] = -mean_pressure;
        properties[StageLayout::velocity]     = 0.6 * speed;
        properties[StageLayout::velocity + 1] = 0.8 * speed;
      });
      fixture.stage->step();
    }

    /// Call `function(velocity)` for particles that no boundary is near to.
    template <typename Function>
    void
    for_each_inside(const Function &function) const
    {
      unsigned int n_inside = 0;
      fixture.for_each_particle(
        [&](auto, const dealii::Point<2> &position, const auto &properties) {
          if (std::abs(position[0] - 0.5) < 0.2 &&
              std::abs(position[1] - 0.5) < 0.2)
            {
              ++n_inside;
              function(properties[StageLayout::velocity],
                       properties[StageLayout::velocity + 1]);
            }
        });
      EXPECT_GT(n_inside, 20u);
    }

    StageFixture fixture;
  };
} // namespace



// The loss is 2 mu p dt / (rho W), against the motion.
TEST_P(BoxFrictionTest, slows_down_what_moves)
{
  constexpr double time_step = 1e-4, speed = 1.;
  start(speed, time_step);
  const double loss = 2. * std::tan(angle * dealii::numbers::PI / 180.) *
                      mean_pressure * time_step /
                      (fixture.material.density * depth);
  EXPECT_GT(loss, 1e-3);
  for_each_inside([&](const double x, const double y) {
    EXPECT_NEAR(x, 0.6 * (speed - loss), 1e-12);
    EXPECT_NEAR(y, 0.8 * (speed - loss), 1e-12);
  });
  // Forces at the boundary change speeds there by some thousandths.
  const FlowTotals totals = fixture.stage->view().totals();
  EXPECT_NEAR(fixture.stage->dissipation() /
                (mass_of_all(totals) * loss * (speed - 0.5 * loss)),
              1.,
              1e-2);
}



TEST_P(BoxFrictionTest, stops_what_is_slow)
{
  start(1e-4, 1e-4);
  for_each_inside([](const double x, const double y) {
    EXPECT_NEAR(x, 0., 1e-15);
    EXPECT_NEAR(y, 0., 1e-15);
  });
}



INSTANTIATE_TEST_SUITE_P(CellTypes,
                         BoxFrictionTest,
                         testing::Values(CellType::triangle,
                                         CellType::quadrilateral));
