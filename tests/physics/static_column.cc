#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "static_fixture.h"

using namespace Sandglass;

namespace
{
  constexpr double height = 2., width = 0.5;

  using Column = std::tuple<CellType, Formulation>;

  /**
   * A column between smooth walls: uniaxial strain. phi = 40 degrees keeps it
   * elastic (2 G / K = 0.92 < m = 1.35), and E = 1 GPa the strains so small
   * (3e-5) that linear elasticity is the closed form.
   */
  class ColumnTest : public testing::TestWithParam<Column>
  {
  protected:
    ColumnTest()
    {
      fixture.material.young_modulus           = 1e9;
      fixture.material.internal_friction_angle = 40.;
      fixture.walls.friction_angle             = 0.;
      fixture.walls.fix_bottom_corner          = false;
      fixture.formulation                      = std::get<1>(GetParam());

      Rectangle rectangle;
      rectangle.cell_type = std::get<0>(GetParam());
      rectangle.upper     = Point<2>(width, height);
      rectangle.n_x       = 5;
      rectangle.n_y       = 20;
      fixture.run(rectangle.mesh());
    }

    double
    vertical_stress(const double y) const
    {
      return -1500. * 9.81 * (height - y);
    }

    /// Triangles share their weight unevenly between the nodes.
    double
    tolerance() const
    {
      return std::get<0>(GetParam()) == CellType::triangle ? 0.02 : 1e-4;
    }

    StaticFixture fixture;
    const double  scale = 1500. * 9.81 * height;
  };
} // namespace



TEST_P(ColumnTest, StressIsThatOfUniaxialStrain)
{
  double largest = 0.;
  fixture.for_each_cell([&](const auto &cell, const auto &cell_state) {
    const auto   stress   = fixture.mean_stress(cell_state);
    const double y        = cell->barycenter()[1];
    const double vertical = vertical_stress(y);
    const double lateral  = 0.3 / 0.7 * vertical; // nu / (1 - nu)
    largest               = std::max({largest,
                                      std::abs(stress[Component::xx] - lateral) / scale,
                                      std::abs(stress[Component::yy] - vertical) / scale,
                                      std::abs(stress[Component::zz] - lateral) / scale,
                                      std::abs(stress[Component::xy]) / scale});
  });
  std::cout << "largest stress difference / (rho g H) " << largest << std::endl;
  EXPECT_LT(largest, tolerance());
}



TEST_P(ColumnTest, SurfaceSettlesByTheClosedForm)
{
  // u = rho g H^2 / (2 M) with the confined modulus M
  const double settlement = 1500. * 9.81 * height * height /
                            (2. * fixture.elasticity().confined_modulus());
  double smallest = 1e300, largest = -1e300;
  fixture.for_each_cell([&](const auto &cell, const auto &cell_state) {
    for (const unsigned int v : cell->vertex_indices())
      if (cell->vertex(v)[1] > height - 1e-9)
        {
          const double ratio = -cell_state.displacement[v][1] / settlement;
          smallest           = std::min(smallest, ratio);
          largest            = std::max(largest, ratio);
        }
  });
  std::cout << "settlement / closed form " << smallest << " to " << largest
            << std::endl;
  EXPECT_NEAR(smallest, 1., tolerance());
  EXPECT_NEAR(largest, 1., tolerance());
}



TEST_P(ColumnTest, WallsCarryTheLateralStress)
{
  double lateral_force = 0.;
  for (const WallForce<2> &force : fixture.state.wall_forces)
    {
      EXPECT_NEAR(fixture.tangential_force(force) / (scale * width), 0., 1e-12);
      if (fixture.role_of(force.wall) == BoundaryRole::wall)
        lateral_force += force.normal_force();
    }
  // integral of nu / (1 - nu) rho g (H - y) over the wall
  double expected = 0.3 / 0.7 * 1500. * 9.81 * height * height / 2.;
  if (fixture.formulation == Formulation::axisymmetric)
    expected *= 2. * numbers::PI * width;
  std::cout << "lateral force / closed form " << lateral_force / expected
            << std::endl;
  EXPECT_NEAR(lateral_force / expected, 1., tolerance());
}

INSTANTIATE_TEST_SUITE_P(
  Columns,
  ColumnTest,
  testing::Combine(testing::Values(CellType::triangle, CellType::quadrilateral),
                   testing::Values(Formulation::plane_strain,
                                   Formulation::axisymmetric)));
