#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <map>

#include "solid_fixture.h"
#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  constexpr double       width = 0.6, height = 0.5, edge = 0.05, step = 1e-4;
  constexpr unsigned int n_x = 12, n_y = 10;

  bool
  is_of_column(const double x, const double y)
  {
    return x < 0.3 && y < 0.4;
  }
} // namespace

// A column that collapses between two smooth walls one cell apart moves as in
// plane strain: nothing but rounding is added by the third direction.
TEST(SolidSlice, OneCellDeepIsPlaneStrain)
{
  SolidFixture solid;
  solid.set_time_step(step);
  Box box;
  box.upper     = Point<3>(width, height, edge);
  box.n         = {{n_x, n_y, 1}};
  box.roles[2]  = {{BoundaryRole::axis, BoundaryRole::axis}};
  box.is_filled = [](const Point<3> &p) { return is_of_column(p[0], p[1]); };
  auto &slice   = solid.start(box.mesh());

  StageFixture plane;
  plane.material.yield_cone = solid.material.yield_cone;
  plane.set_time_step(step);
  Rectangle rectangle;
  rectangle.cell_type = CellType::quadrilateral;
  rectangle.upper     = Point<2>(width, height);
  rectangle.n_x       = n_x;
  rectangle.n_y       = n_y;
  rectangle.left      = BoundaryRole::wall;
  rectangle.is_filled = [](const Point<2> &p) {
    return is_of_column(p[0], p[1]);
  };
  auto &section = plane.start(rectangle.mesh());

  for (unsigned int n = 0; n < 600; ++n)
    {
      slice.step();
      section.step();
    }

  // Pairs of particles have started from the same place of the section.
  using Place         = std::pair<long, long>;
  const auto place_of = [](const auto &start) {
    return Place(std::lround(start[0] / 1e-6), std::lround(start[1] / 1e-6));
  };
  struct State
  {
    Point<2>              position;
    std::array<double, 4> stress;
  };
  std::map<Place, State> expected;
  plane.for_each_particle([&](auto id, const auto &position, auto state) {
    State &of_section   = expected[place_of(section.initial_position(id))];
    of_section.position = position;
    std::copy_n(state.begin() + StageLayout::stress,
                4,
                of_section.stress.begin());
  });
  double       position_difference = 0., stress_difference = 0., largest = 0.;
  double       way = 0.;
  unsigned int n   = 0;
  solid.for_each_particle([&](auto id, const auto &position, auto state) {
    const Point<3> start      = slice.initial_position(id);
    const State   &of_section = expected.at(place_of(start));
    way                       = std::max(way, position.distance(start));
    position_difference =
      std::max({position_difference,
                std::abs(position[0] - of_section.position[0]),
                std::abs(position[1] - of_section.position[1]),
                std::abs(position[2] - start[2])});
    for (unsigned int c = 0; c < 6; ++c)
      {
        const double stress = c < 4 ? of_section.stress[c] : 0.;
        largest             = std::max(largest, std::abs(stress));
        stress_difference =
          std::max(stress_difference,
                   std::abs(state[SolidFixture::Layout::stress + c] - stress));
      }
    ++n;
  });
  std::cout << "farthest way " << way << " m, differences "
            << position_difference << " m and " << stress_difference / largest
            << " of the stress" << std::endl;
  EXPECT_EQ(n, 2 * expected.size());
  EXPECT_GT(way, 0.01);
  EXPECT_LT(position_difference, 1e-10);
  EXPECT_LT(stress_difference / largest, 1e-8);

  const auto of_slice   = slice.view().totals(),
             of_section = section.view().totals();
  EXPECT_NEAR(of_slice.dissipated_energy / edge / of_section.dissipated_energy,
              1.,
              1e-8);
}
