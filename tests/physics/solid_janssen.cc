#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <vector>

#include "solid_rest_fixture.h"

using namespace Sandglass;

namespace
{
  constexpr double half_width = 0.25, height = 4.; // eight widths
  constexpr double unit_weight = 1500. * 9.81;     // N/m^3

  /// The middle part of the height, away from the free surface and the floor.
  constexpr double lower_end = height / 4., upper_end = 3. * height / 4.;

  /// A quarter of a closed square silo.
  class SolidJanssen : public testing::TestWithParam<CellType>
  {
  protected:
    SolidJanssen()
    {
      using Role = BoundaryRole;
      Box box;
      box.cell_type = GetParam();
      box.upper     = Point<3>(half_width, height, half_width);
      box.n         = {{4, 48, 4}};
      box.roles     = {{{{Role::axis, Role::wall}},
                        {{Role::floor, Role::top}},
                        {{Role::axis, Role::wall}}}};
      state         = rest.run(box.mesh());
    }

    /// Mean horizontal over mean vertical stress in the middle part.
    double
    stress_ratio() const
    {
      double horizontal = 0., vertical = 0.;
      for (const auto &cell : rest.scene->triangulation.active_cell_iterators())
        {
          const double y = cell->barycenter()[1];
          if (y < lower_end || y > upper_end)
            continue;
          const auto stress =
            rest.mean_stress(state, cell->active_cell_index());
          horizontal += cell->measure() / 2. *
                        (stress[Component::xx] + stress[Component::zz]);
          vertical += cell->measure() * stress[Component::yy];
        }
      return horizontal / vertical;
    }

    SolidRest      rest;
    StaticState<3> state;
  };
} // namespace

INSTANTIATE_TEST_SUITE_P(CellTypes,
                         SolidJanssen,
                         testing::Values(CellType::hexahedron,
                                         CellType::tetrahedron));

// Janssen's pressure, EN 1991-4 eq. 5.1-5.6: p_h = gamma K z0 (1 - exp(-z/z0))
// at the depth z, with z0 = A / (U K mu); A / U of a square is half its half
// width. It is the mean around the silo.
TEST_P(SolidJanssen, WallPressure)
{
  const double K  = stress_ratio();
  const double mu = rest.scene->walls[0].friction_coefficient;
  const double z0 = half_width / 2. / (K * mu);

  constexpr unsigned int n_bands = 6;
  std::vector<double>    force(n_bands), lift(n_bands), expected(n_bands);
  for (const WallForce<3> &node : state.wall_forces)
    {
      const double y = rest.scene->mesh.vertices[node.vertex][1];
      if (rest.scene->walls[node.wall].role != BoundaryRole::wall ||
          y < lower_end || y >= upper_end)
        continue;
      const auto band = static_cast<unsigned int>(n_bands * (y - lower_end) /
                                                  (upper_end - lower_end));
      force[band] += node.normal_force();
      lift[band] += node.force[1];
      expected[band] +=
        node.area * unit_weight * K * z0 * (1. - std::exp(-(height - y) / z0));
    }

  std::cout << "K = " << K << ", z0 = " << z0 << " m\n"
            << "pressure / Janssen's, friction mobilised:";
  for (unsigned int band = 0; band < n_bands; ++band)
    {
      const double ratio     = force[band] / expected[band],
                   mobilised = lift[band] / (mu * force[band]);
      std::cout << ' ' << ratio << ' ' << mobilised;
      EXPECT_NEAR(ratio, 1., 0.05) << "band " << band;
      EXPECT_NEAR(mobilised, 1., 0.02) << "band " << band;
    }
  std::cout << std::endl;
}
