#include <gtest/gtest.h>

#include <algorithm>
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



namespace
{
  /// A silo with a hopper whose walls are rougher than its material, at rest.
  void
  run_rough_hopper(StaticFixture     &fixture,
                   const CellType     cell_type,
                   const unsigned int newton_iterations)
  {
    fixture.silo.cell_type                = cell_type;
    fixture.silo.half_width               = 0.5;
    fixture.silo.wall_height              = 2.;
    fixture.silo.hopper_height            = 0.5;
    fixture.silo.element_size             = 0.1;
    fixture.silo.outlet_is_open           = false;
    fixture.walls.friction_angle          = 28.;
    fixture.parameters.n_load_steps       = 1;
    fixture.parameters.maximum_iterations = newton_iterations;
    fixture.run_silo();
    std::cout << fixture.log_text.str();
  }

  class StaticMethods : public testing::TestWithParam<CellType>
  {};
} // namespace



// Newton's method alone, and relaxation from which it goes on, solve the same
// equations.
TEST_P(StaticMethods, HaveTheSameAnswer)
{
  StaticFixture newton, both;
  run_rough_hopper(newton, GetParam(), 100);
  run_rough_hopper(both, GetParam(), 0);
  EXPECT_EQ(newton.state.effort.n_relaxation_steps, 0u);
  EXPECT_GT(both.state.effort.n_relaxation_steps, 0u);

  double scale = 0., difference = 0.;
  for (unsigned int i = 0; i < newton.state.wall_forces.size(); ++i)
    {
      const auto &force = newton.state.wall_forces[i].force;
      scale             = std::max(scale, force.norm());
      difference =
        std::max(difference, (force - both.state.wall_forces[i].force).norm());
    }
  std::cout << "largest difference of wall forces " << difference / scale
            << " of the largest one" << std::endl;
  EXPECT_LT(difference, 1e-6 * scale);
}

INSTANTIATE_TEST_SUITE_P(CellTypes,
                         StaticMethods,
                         testing::Values(CellType::triangle,
                                         CellType::quadrilateral));
