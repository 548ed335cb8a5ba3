#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "solid_fixture.h"

using namespace Sandglass;

namespace
{
  using Layout = SolidFixture::Layout;

  class SolidRoundWall : public testing::TestWithParam<CellType>
  {};
} // namespace

INSTANTIATE_TEST_SUITE_P(CellTypes,
                         SolidRoundWall,
                         testing::Values(CellType::hexahedron,
                                         CellType::tetrahedron));

// A block runs around inside a smooth round wall. The mesh has facets for it,
// beyond which its nodes' velocity along the wall takes particles: none is
// lost, and the facets brake it less than as many impacts would.
TEST_P(SolidRoundWall, LetsABlockRunAround)
{
  using Role            = BoundaryRole;
  constexpr double spin = 2., inner = 0.6, outer = 1., thickness = 0.2;
  Box              box;
  box.cell_type          = GetParam();
  box.lower              = Point<3>(inner, 0., 0.);
  box.upper              = Point<3>(outer, 0.2, numbers::PI / 2.);
  box.n                  = {{4, 2, 12}};
  box.roles              = {{{{Role::top, Role::wall}},
                             {{Role::floor, Role::floor}},
                             {{Role::wall, Role::wall}}}};
  box.displaces_boundary = true;
  box.displaced          = [](const Point<3> &p) {
    return Point<3>(p[0] * std::cos(p[2]), p[1], p[0] * std::sin(p[2]));
  };
  box.is_filled = [&](const Point<3> &p) {
    const double angle = std::atan2(p[2], p[0]);
    return std::hypot(p[0], p[2]) > outer - thickness && angle > 0.15 &&
           angle < 0.6;
  };
  SolidFixture fixture;
  fixture.gravity                 = Tensor<1, 3>();
  fixture.walls.friction_angle    = 0.;
  fixture.walls.fix_bottom_corner = false;
  fixture.material.cohesion       = 1e4; // so that it stays a block
  auto        &stage              = fixture.start(box.mesh());
  const double mass               = stage.view().totals().mass_in_silo;
  fixture.change_particles([&](auto, const auto &position, auto state) {
    state[Layout::velocity]     = -spin * position[2];
    state[Layout::velocity + 2] = spin * position[0];
  });
  const double start = fixture.angular_momentum()[1];
  while (stage.view().clock().time < 0.35)
    stage.step();

  EXPECT_NEAR(stage.view().totals().mass_in_silo, mass, 1e-12 * mass);
  const double kept = fixture.angular_momentum()[1] / start;
  std::cout << "angular momentum kept " << kept << std::endl;
  // From one facet to the next the direction turns by 7.5 degrees, of which an
  // impact leaves the cosine; in 0.7 rad there are five.
  const double after_impacts = std::pow(std::cos(numbers::PI / 24.), 5);
  EXPECT_GT(kept, after_impacts);
  EXPECT_LT(kept, 1. + 0.2 * (1. - after_impacts));
}
