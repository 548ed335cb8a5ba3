#include <gtest/gtest.h>

#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  constexpr double g = 9.81, degree = dealii::numbers::PI / 180.;

  /**
   * A flat heap on a floor that is tilted by `angle`. The heap's sides are less
   * steep than its internal friction allows: a block of material without
   * cohesion could not keep its shape.
   */
  class Incline
  {
  public:
    Incline(const double angle, const double wall_friction_angle)
    {
      fixture.gravity = Tensor<1, 2>(
        {g * std::sin(angle * degree), -g * std::cos(angle * degree)});
      fixture.material.internal_friction_angle = 60.;
      fixture.walls.friction_angle             = wall_friction_angle;
      fixture.parameters.end_time              = 10.;
      Rectangle rectangle;
      rectangle.left      = BoundaryRole::wall;
      rectangle.upper     = Point<2>(4., 0.4);
      rectangle.n_x       = 80;
      rectangle.n_y       = 8;
      rectangle.is_filled = [](const Point<2> &center) {
        return center[1] < 0.15 && center[0] - center[1] / 0.3 > 0.5 &&
               center[0] + center[1] / 0.3 < 2.;
      };
      fixture.start(rectangle.mesh());
    }

    /// Mean velocity along the slope.
    double
    velocity() const
    {
      double mass = 0., momentum = 0.;
      fixture.for_each_particle([&](auto, auto, auto state) {
        mass += state[StageLayout::mass];
        momentum += state[StageLayout::mass] * state[StageLayout::velocity];
      });
      return momentum / mass;
    }

    double
    velocity_at(const double time)
    {
      while (fixture.stage->view().clock().time < time)
        fixture.stage->step();
      return velocity();
    }

    StageFixture fixture;
  };
} // namespace

TEST(InclinedPlane, SlidesWithTheAccelerationOfCoulombFriction)
{
  Incline      incline(35., 20.);
  const double early_velocity = incline.velocity_at(0.1);
  const double early          = incline.fixture.stage->view().clock().time;
  const double late_velocity  = incline.velocity_at(0.6);
  const double late           = incline.fixture.stage->view().clock().time;

  const double expected = g * (std::sin(35. * degree) -
                               std::tan(20. * degree) * std::cos(35. * degree));
  const double measured = (late_velocity - early_velocity) / (late - early);
  std::cout << "acceleration / expected " << measured / expected << std::endl;
  EXPECT_NEAR(measured / expected, 1., 0.01);
}

TEST(InclinedPlane, SticksBelowTheFrictionAngle)
{
  Incline      incline(15., 20.);
  const double early_velocity = incline.velocity_at(0.3);
  const double late_velocity  = incline.velocity_at(1.3);
  std::cout << "velocities " << early_velocity << ' ' << late_velocity << " m/s"
            << std::endl;
  // Free sliding would reach 2.5 m/s.
  EXPECT_NEAR(early_velocity, 0., 0.01);
  EXPECT_NEAR(late_velocity, 0., 0.01);
}
