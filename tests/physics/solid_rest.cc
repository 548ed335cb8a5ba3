#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "solid_rest_fixture.h"

using namespace Sandglass;

namespace
{
  class SolidRestOf : public testing::TestWithParam<CellType>
  {};
} // namespace

INSTANTIATE_TEST_SUITE_P(CellTypes,
                         SolidRestOf,
                         testing::Values(CellType::hexahedron,
                                         CellType::tetrahedron));

// Between smooth walls the vertical stress is the weight above, the horizontal
// one what confined elasticity makes of it.
TEST_P(SolidRestOf, AColumnBetweenSmoothWallsIsConfinedCompression)
{
  SolidRest rest;
  rest.walls.friction_angle             = 0.;
  rest.material.internal_friction_angle = 50.;
  Box box;
  box.cell_type      = GetParam();
  box.upper          = Point<3>(0.4, 1., 0.3);
  box.n              = {{4, 10, 3}};
  const auto   state = rest.run(box.mesh());
  const double nu    = rest.material.poisson_ratio;
  for (const auto &cell : rest.scene->triangulation.active_cell_iterators())
    {
      const auto   stress = rest.mean_stress(state, cell->active_cell_index());
      const double weight =
        rest.material.density * 9.81 * (1. - cell->center()[1]);
      const double full = rest.material.density * 9.81;
      // Tetrahedra are constant where the column is linear.
      const double bound = GetParam() == CellType::hexahedron ? 2e-3 : 0.05;
      EXPECT_NEAR(stress[Component::yy] / full, -weight / full, bound);
      for (const int c : {Component::xx, Component::zz})
        EXPECT_NEAR(stress[c] / full, -nu / (1. - nu) * weight / full, bound);
    }
  const double weight = rest.material.density * 9.81 * 0.4 * 1. * 0.3;
  EXPECT_NEAR(rest.force_of_walls(state)[1] / weight, 1., 1e-6);
}

TEST_P(SolidRestOf, RoughWallsBearTheWeightTogetherWithTheFloor)
{
  SolidRest rest;
  rest.walls.friction_angle = 20.;
  Box box;
  box.cell_type       = GetParam();
  box.upper           = Point<3>(0.4, 1.2, 0.4);
  box.n               = {{4, 12, 4}};
  const auto   state  = rest.run(box.mesh());
  const double weight = rest.material.density * 9.81 * 0.4 * 1.2 * 0.4;
  double       lift = 0., of_floor = 0.;
  for (const auto &force : state.wall_forces)
    {
      lift += force.force[1];
      if (rest.scene->walls[force.wall].role == BoundaryRole::floor)
        of_floor += force.force[1];
      const Tensor<1, 3> tangential =
        force.force - (force.force * force.normal) * force.normal;
      EXPECT_LE(tangential.norm(),
                1.001 * std::tan(20. * numbers::PI / 180.) *
                    std::max(0., force.normal_force()) +
                  1e-6 * weight);
    }
  std::cout << "floor's share " << of_floor / weight << std::endl;
  EXPECT_NEAR(lift / weight, 1., 1e-5);
  EXPECT_LT(of_floor / weight, 0.8);
}
