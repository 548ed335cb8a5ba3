#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "heap.h"

using namespace Sandglass;

namespace
{
  constexpr double g = 9.81, degree = dealii::numbers::PI / 180.;

  /// A heap on a floor that is tilted by `angle`.
  class Incline : public Heap
  {
  public:
    Incline(
      const double angle,
      const double wall_friction_angle,
      const double loosest_density = ParticleStageParameters().loosest_density)
    {
      fixture.parameters.loosest_density = loosest_density;
      fixture.gravity                    = Tensor<1, 2>(
        {g * std::sin(angle * degree), -g * std::cos(angle * degree)});
      fixture.walls.friction_angle = wall_friction_angle;
      fixture.start(rectangle.mesh());
    }
  };
} // namespace

TEST(InclinedPlane, SlidesWithTheAccelerationOfCoulombFriction)
{
  Incline      incline(35., 20.);
  const double early_velocity = incline.velocity_at(0.1);
  const double early          = incline.time();
  const double late_velocity  = incline.velocity_at(0.6);
  const double late           = incline.time();

  const double expected = g * (std::sin(35. * degree) -
                               std::tan(20. * degree) * std::cos(35. * degree));
  const double measured = (late_velocity - early_velocity) / (late - early);
  std::cout << "acceleration / expected " << measured / expected << std::endl;
  EXPECT_NEAR(measured / expected, 1., 0.01);
}

// Free sliding would reach 2.5 m/s.
TEST(InclinedPlane, SticksBelowTheFrictionAngle)
{
  Incline      incline(15., 20., 1.);
  const double early_velocity = incline.velocity_at(0.3);
  const double late_velocity  = incline.velocity_at(1.3);
  std::cout << "velocities " << early_velocity << ' ' << late_velocity << " m/s"
            << std::endl;
  EXPECT_NEAR(early_velocity, 0., 0.01);
  EXPECT_NEAR(late_velocity, 0., 0.01);
}

// It starts without stress, and loosens while it swings: for two seconds it
// creeps with 7 mm/s.
TEST(InclinedPlane, LoosenedMaterialComesToRest)
{
  Incline      incline(15., 20.);
  const double early_velocity = incline.velocity_at(0.3);
  const double late_velocity  = incline.velocity_at(3.);
  std::cout << "velocities " << early_velocity << ' ' << late_velocity << " m/s"
            << std::endl;
  EXPECT_NEAR(early_velocity, 0., 0.02);
  EXPECT_NEAR(late_velocity, 0., 1e-3);
}
