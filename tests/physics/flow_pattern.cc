#include <sandglass/output/flow_pattern.h>

#include <gtest/gtest.h>

#include <cmath>

#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  /// A layer on an inclined plane: the floor of a box in tilted gravity, with
  /// smooth ends far apart.
  FlowPattern
  layer_on_incline(const double inclination, const double stagnant_displacement)
  {
    const double angle = inclination * numbers::PI / 180.;
    StageFixture fixture;
    fixture.material.internal_friction_angle = 60.;
    fixture.walls.friction_angle             = 20.;
    fixture.walls.fix_bottom_corner          = false;
    fixture.parameters.time_step_text        = "2e-4";
    fixture.gravity =
      Tensor<1, 2>({9.81 * std::sin(angle), -9.81 * std::cos(angle)});
    Rectangle rectangle;
    rectangle.left      = BoundaryRole::wall;
    rectangle.upper     = Point<2>(4., 0.5);
    rectangle.n_x       = 32;
    rectangle.n_y       = 4;
    rectangle.is_filled = [](const Point<2> &center) {
      return center[0] > 0.9 && center[0] < 2.9 && center[1] < 0.25;
    };
    auto &stage = fixture.start(rectangle.mesh());
    while (stage.view().clock().time < 0.3)
      stage.step();
    return {stage.view(),
            stagnant_displacement,
            fixture.scene->symmetry_factor,
            MPI_COMM_WORLD};
  }
} // namespace



// 0.5 m^2 of 1500 kg/m^3. At 30 degrees it slides by
// (sin 30 - tan 20 cos 30) g t^2 / 2 = 0.0816 m in 0.3 s.
TEST(FlowPattern, ASlidingLayerSlipsAndIsNotStagnant)
{
  const FlowPattern flow = layer_on_incline(30., 0.05);
  EXPECT_GT(flow.slipping_wall_share, 0.9);
  EXPECT_NEAR(flow.stagnant_mass.value(), 0., 1e-9);
  // Its front spreads.
  EXPECT_GT(layer_on_incline(30., 0.12).stagnant_mass.value(), 0.95 * 750.);
}



TEST(FlowPattern, AStickingLayerIsStagnant)
{
  const FlowPattern rest = layer_on_incline(10., 0.05);
  EXPECT_LT(rest.slipping_wall_share, 0.2);
  EXPECT_NEAR(rest.stagnant_mass.value(), 750., 1e-9);
  EXPECT_FALSE(layer_on_incline(10., 0.).stagnant_mass.has_value());
}
