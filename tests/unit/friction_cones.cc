#include <deal.II/base/numbers.h>

#include <sandglass/walls/friction_cones.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "random_engine.h"

using namespace Sandglass;

namespace
{
  using Force = Tensor<1, 2>;

  /// Of length 1, at an angle to the x axis.
  Force
  at_angle(const double degrees)
  {
    const double angle = degrees * numbers::PI / 180.;
    return Force({std::cos(angle), std::sin(angle)});
  }



  Support<2>
  wall(const double normal_angle, const double friction_angle)
  {
    Support<2> support;
    support.normal = at_angle(normal_angle);
    support.friction_coefficient =
      std::tan(friction_angle * numbers::PI / 180.);
    return support;
  }
} // namespace



// A vertical wall to the right and a hopper below it press to the left (180
// degrees) and up to the left (120 degrees), each 20 degrees to both sides.
TEST(FrictionCones, OfWallAndHopperReachFromOneEdgeToTheOther)
{
  const FrictionCones<2> cones(Supports<2>{wall(0., 20.), wall(-60., 20.)});
  EXPECT_TRUE(cones.are_several());
  for (const double inside : {100.5, 120., 150., 180., 199.5})
    EXPECT_TRUE(cones.contain(3. * at_angle(inside))) << inside;
  for (const double outside : {99.5, 0., -90., 200.5})
    EXPECT_FALSE(cones.contain(3. * at_angle(outside))) << outside;
}



TEST(FrictionCones, SmoothAndMovingWallsBearAlongTheirNormals)
{
  Support<2> belt = wall(-60., 20.);
  belt.velocity   = at_angle(30.);
  for (const Support<2> &lower : {wall(-60., 0.), belt})
    {
      const FrictionCones<2> cones(Supports<2>{wall(0., 0.), lower});
      for (const double inside : {120.5, 150., 179.5})
        EXPECT_TRUE(cones.contain(at_angle(inside))) << inside;
      for (const double outside : {119.5, 180.5, -30.})
        EXPECT_FALSE(cones.contain(at_angle(outside))) << outside;
    }
}



TEST(FrictionCones, OneWallOrTheAxisBesideItIsNoCorner)
{
  Support<2> axis = wall(180., 0.);
  axis.is_axis    = true;
  EXPECT_FALSE(FrictionCones<2>(Supports<2>{wall(0., 20.)}).are_several());
  EXPECT_FALSE(
    FrictionCones<2>(Supports<2>{axis, wall(-90., 20.)}).are_several());
}



// Any sum of forces that the walls can exert one by one is contained.
TEST(FrictionCones, ContainSumsOfWhatTheWallsExert)
{
  auto                                   engine = random_engine();
  std::uniform_real_distribution<double> share(0., 1.);
  for (unsigned int i = 0; i < 200; ++i)
    {
      const double between = 5. + 90. * share(engine);
      const double first = 40. * share(engine), second = 40. * share(engine);
      const FrictionCones<2> cones(
        Supports<2>{wall(0., first), wall(-between, second)});
      const Force sum =
        share(engine) *
          at_angle(180. + first * (1.99 * share(engine) - 0.995)) +
        share(engine) *
          at_angle(180. - between + second * (1.99 * share(engine) - 0.995));
      EXPECT_TRUE(cones.contain(sum)) << between << ' ' << sum;
    }
}
