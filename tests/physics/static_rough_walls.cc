#include <gtest/gtest.h>

#include <iostream>

#include "static_fixture.h"

using namespace Sandglass;

// Walls about as rough as the material: phi = 25 degrees on the cone are 30
// degrees of Coulomb friction in plane flow, so wall and material beside it
// slip together, and the border of the slipping part has to find its way up the
// wall. A smaller load step wouldn't help: without cohesion, the state at a
// tenth of the weight is a tenth of the state.
TEST(StaticRoughWalls, FindTheStateAtRestInTheFirstLoadStep)
{
  StaticFixture fixture;
  fixture.walls.friction_angle          = 30.;
  fixture.walls.fix_bottom_corner       = false;
  fixture.parameters.maximum_iterations = 40;
  fixture.parameters.smallest_load_step = 0.2;

  Rectangle rectangle;
  rectangle.upper = Point<2>(0.1, 0.2);
  rectangle.n_x   = 20;
  rectangle.n_y   = 40;
  ASSERT_NO_THROW(fixture.run(rectangle.mesh())) << fixture.log_text.str();
  std::cout << fixture.log_text.str();
  EXPECT_NEAR(fixture.lift() / fixture.weight(), 1., 1e-9);
}
