
#include <gtest/gtest.h>

#include <cmath>

#include "rest.h"
#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  constexpr double       height = 2., radius = 0.5;
  constexpr unsigned int n_columns = 4, n_rows = 20;
  constexpr double       unit_weight = 1500. * 9.81; // N/m^3
  constexpr double       scale       = unit_weight * height;

  /**
   * A cylinder of material between smooth walls, in uniaxial strain: as in
   * static_column.cc, phi = 40 degrees keeps it elastic, and E = 1 GPa the
   * strains small.
   */
  class CylinderAtRest : public testing::TestWithParam<CellType>
  {
  protected:
    CylinderAtRest()
    {
      fixture.formulation                      = Formulation::axisymmetric;
      fixture.material.young_modulus           = 1e9;
      fixture.material.internal_friction_angle = 40.;
      fixture.walls.friction_angle             = 0.;
      fixture.walls.fix_bottom_corner          = false;
      fixture.parameters.end_time              = 0.05;
      Rectangle rectangle;
      rectangle.cell_type = GetParam();
      rectangle.upper     = Point<2>(radius, height);
      rectangle.n_x       = n_columns;
      rectangle.n_y       = n_rows;
      fixture.start(rectangle.mesh());

      start_from_rest(fixture);
    }

    /// Largest strain, rho g H / M.
    double
    strain() const
    {
      return scale / fixture.elasticity().confined_modulus();
    }

    /// Largest difference of a row's mean vertical stress from -rho g depth,
    /// over rho g H. Equilibrium makes the mean exact, whatever the stresses
    /// of the single cells are, since a row's shape functions add up to linear
    /// ones and smooth walls carry no weight. Triangles give the nodes above
    /// and below a row not quite the same share of its weight; the diagonals'
    /// directions make up for each other where n_x is even.
    double
    vertical_stress_error() const
    {
      std::array<double, n_rows> sums{}, volumes{};
      fixture.for_each_particle([&](auto id, auto &, auto state) {
        const double y   = fixture.stage->initial_position(id)[1];
        const auto   row = static_cast<unsigned int>(n_rows * y / height);
        const double volume =
          state[StageLayout::mass] / state[StageLayout::density];
        volumes[row] += volume;
        sums[row] += volume * state[StageLayout::stress + Component::yy];
      });
      double largest = 0.;
      for (unsigned int row = 0; row < n_rows; ++row)
        {
          const double depth = height * (n_rows - row - 0.5) / n_rows;
          largest =
            std::max(largest,
                     std::abs(sums[row] / volumes[row] + unit_weight * depth) /
                       scale);
        }
      return largest;
    }

    double
    axial_momentum() const
    {
      double sum = 0.;
      fixture.for_each_particle([&](auto, auto &, auto state) {
        sum += state[StageLayout::mass] * state[StageLayout::velocity + 1];
      });
      return sum;
    }

    double
    weight() const
    {
      double sum = 0.;
      fixture.for_each_particle([&](auto, auto &, auto state) {
        sum += 9.81 * state[StageLayout::mass];
      });
      return sum;
    }

    StageFixture fixture;
  };
} // namespace



// The particles' sums use the undeformed grid, the state at rest was found on
// the deformed one: forces are out of balance by the strain, and material that
// swings freely about its rest goes twice as far. Triangles have one quadrature
// point in the static stage and four particles here, so that at the axis, where
// the radius varies most, up to half of a node's weight is out of balance:
// twice half the weight of a row's innermost ring.
TEST_P(CylinderAtRest, VerticalStressIsTheWeightAbove)
{
  const double before  = vertical_stress_error();
  double       largest = before;
  while (!fixture.stage->is_finished())
    {
      fixture.stage->step();
      largest = std::max(largest, vertical_stress_error());
    }
  std::cout << "largest strain                             " << strain()
            << "\nvertical stress error / (rho g H), static  " << before
            << "\nvertical stress error / (rho g H), largest " << largest
            << "\nsteps " << fixture.stage->view().clock().step << std::endl;
  const double ring = GetParam() == CellType::triangle ?
                        1. / (n_columns * n_columns * n_rows) :
                        0.;
  EXPECT_LT(before, strain());
  EXPECT_LT(largest, 2. * strain() + ring);
}



// Mean over 25 passages of a wave through the height.
TEST_P(CylinderAtRest, WallPressureIsLinear)
{
  while (!fixture.stage->is_finished())
    fixture.stage->step();
  double largest = 0., lateral_force = 0.;
  for (const MeanWallForce &force : fixture.take_mean_forces())
    if (fixture.role_of(force.wall) == BoundaryRole::wall)
      {
        EXPECT_NEAR(force.tangential_force() / (scale * radius), 0., 1e-14);
        lateral_force += force.normal_force();
        // The end nodes' share of the wall lies to one side of them.
        const double y = force.position[1];
        if (y < 1e-9 || y > height - 1e-9)
          continue;
        const double expected = 0.3 / 0.7 * unit_weight * (height - y);
        largest =
          std::max(largest,
                   std::abs(force.normal_force() / force.tributary_area -
                            expected) /
                     scale);
      }
  const double expected_force =
    0.3 / 0.7 * unit_weight * height * height / 2. * 2. * numbers::PI * radius;
  std::cout << "largest pressure difference / (rho g H) " << largest
            << "\nlateral force / closed form              "
            << lateral_force / expected_force << std::endl;
  // Triangles share their weight unevenly, as in the static column.
  const double tolerance = GetParam() == CellType::triangle ? 0.02 : 1e-4;
  EXPECT_LT(largest, tolerance);
  EXPECT_NEAR(lateral_force / expected_force, 1., tolerance);
}



// The difference between the weight's impulse and the floor's is momentum.
TEST_P(CylinderAtRest, TheFloorCarriesTheWeight)
{
  while (!fixture.stage->is_finished())
    fixture.stage->step();
  double lift = 0.;
  for (const MeanWallForce &force : fixture.take_mean_forces())
    lift += force.force[1];
  const double momentum_rate =
    axial_momentum() / fixture.stage->view().clock().time;
  std::cout << "lift / weight - 1             " << lift / weight() - 1.
            << "\nrate of momentum / weight     " << momentum_rate / weight()
            << std::endl;
  EXPECT_NEAR((lift - momentum_rate) / weight(), 1., 1e-12);
  EXPECT_NEAR(lift / weight(), 1., 2. * strain());
}

INSTANTIATE_TEST_SUITE_P(CellTypes,
                         CylinderAtRest,
                         testing::Values(CellType::triangle,
                                         CellType::quadrilateral));
