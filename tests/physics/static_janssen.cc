#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <vector>

#include "static_fixture.h"

using namespace Sandglass;

namespace
{
  constexpr double half_width = 0.25, height = 4.; // eight widths
  constexpr double unit_weight = 1500. * 9.81;     // N/m^3

  /// The middle part of the height, away from the free surface and the floor.
  constexpr double lower_end = height / 4., upper_end = 3. * height / 4.;

  class JanssenTest : public testing::TestWithParam<Formulation>
  {
  protected:
    JanssenTest()
    {
      fixture.silo.half_width        = half_width;
      fixture.silo.wall_height       = height;
      fixture.silo.outlet_half_width = 0.1;
      fixture.silo.element_size      = 0.05;
      fixture.silo.outlet_is_open    = false;
      fixture.formulation            = GetParam();
      fixture.run_silo();
    }

    /// Mean horizontal over mean vertical stress, both averaged over the
    /// volume of the cells in the middle part.
    double
    stress_ratio() const
    {
      double horizontal = 0., vertical = 0.;
      fixture.for_each_cell([&](const auto &cell, const auto &cell_state) {
        const Point<2> center = cell->barycenter();
        if (center[1] < lower_end || center[1] > upper_end)
          return;
        const double volume =
          cell->measure() *
          (GetParam() == Formulation::axisymmetric ? center[0] : 1.);
        const auto stress = fixture.mean_stress(cell_state);
        horizontal += volume * stress[Component::xx];
        vertical += volume * stress[Component::yy];
      });
      return horizontal / vertical;
    }

    StaticFixture fixture;
  };
} // namespace



// Janssen's pressure, EN 1991-4 eq. 5.1-5.6: p_h = gamma K z0 (1 - exp(-z/z0))
// at the depth z, with z0 = A / (U K mu): half width / (K mu) between two plane
// walls, half of that in a cylinder.
TEST_P(JanssenTest, WallPressure)
{
  const double K  = stress_ratio();
  const double mu = fixture.scene->walls[0].friction_coefficient;
  const double z0 =
    half_width / (K * mu) / (GetParam() == Formulation::axisymmetric ? 2. : 1.);

  // Means over bands of the wall, several nodes each.
  constexpr unsigned int n_bands = 8;
  std::vector<double>    force(n_bands), friction(n_bands), area(n_bands),
    expected(n_bands);
  for (const WallForce<2> &node : fixture.state.wall_forces)
    {
      const double y = fixture.position_of(node)[1];
      if (fixture.role_of(node.wall) != BoundaryRole::wall || y < lower_end ||
          y >= upper_end)
        continue;
      const auto   band = static_cast<unsigned int>(n_bands * (y - lower_end) /
                                                  (upper_end - lower_end));
      const double z    = height - y;
      force[band] += node.normal_force();
      friction[band] += fixture.tangential_force(node);
      area[band] += node.area;
      expected[band] +=
        node.area * unit_weight * K * z0 * (1. - std::exp(-z / z0));
    }

  std::cout << "K = " << K << ", z0 = " << z0 << " m\n"
            << "pressure / Janssen's:";
  for (unsigned int band = 0; band < n_bands; ++band)
    {
      const double ratio = force[band] / expected[band];
      std::cout << ' ' << ratio;
      EXPECT_NEAR(ratio, 1., 0.05) << "band " << band;
      EXPECT_NEAR(friction[band] / (mu * force[band]), 1., 1e-9);
      EXPECT_GT(area[band], 0.);
    }
  std::cout << std::endl;
}

INSTANTIATE_TEST_SUITE_P(Formulations,
                         JanssenTest,
                         testing::Values(Formulation::plane_strain,
                                         Formulation::axisymmetric));
