#include <sandglass/base/exceptions.h>
#include <sandglass/material/drucker_prager.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <vector>

#include "static_fixture.h"

using namespace Sandglass;

namespace
{
  using Silo = std::tuple<CellType, Formulation, double>;

  /// The paper's material in its plane silo, coarse, with either bottom.
  class SiloTest : public testing::TestWithParam<Silo>
  {
  protected:
    SiloTest()
    {
      fixture.silo.cell_type     = std::get<0>(GetParam());
      fixture.silo.hopper_height = std::get<2>(GetParam());
      fixture.silo.wall_height   = 1.3;
      fixture.silo.element_size  = 0.1;
      fixture.formulation        = std::get<1>(GetParam());
      fixture.run_silo();
    }

    StaticFixture fixture;
  };
} // namespace



TEST_P(SiloTest, WallsAndFloorCarryTheWeight)
{
  const double balance = fixture.lift() / fixture.weight();
  std::cout << "wall and floor reactions / weight " << balance << std::endl;
  EXPECT_NEAR(balance, 1., 1e-8);
}



TEST_P(SiloTest, FrictionStaysWithinCoulombsLaw)
{
  const double mu        = fixture.scene->walls[0].friction_coefficient;
  const double scale     = fixture.weight();
  unsigned int n_sliding = 0;
  for (const WallForce<2> &force : fixture.state.wall_forces)
    {
      const double limit = mu * std::max(force.normal_force(), 0.);
      EXPECT_LE(std::abs(fixture.tangential_force(force)) / scale,
                limit / scale + 1e-12);
      n_sliding +=
        std::abs(fixture.tangential_force(force)) > (1. - 1e-9) * limit &&
        force.normal_force() > 0.;
      // settling material is held back
      if (fixture.role_of(force.wall) == BoundaryRole::wall)
        {
          EXPECT_GE(fixture.tangential_force(force) / scale, -1e-12);
        }
    }
  EXPECT_GT(n_sliding, 0u);
}



TEST_P(SiloTest, StressIsAdmissible)
{
  const DruckerPrager law   = DruckerPrager(fixture.material);
  const double        scale = 1500. * 9.81 * fixture.silo.silo_height();
  fixture.for_each_cell([&](const auto &, const auto &cell_state) {
    for (unsigned int q = 0; q < fixture.n_points(); ++q)
      {
        EXPECT_LE(law.yield_function(cell_state.stress[q]) / scale, 1e-12);
        EXPECT_LT(cell_state.volume_ratio[q], 1.01);
        EXPECT_GT(cell_state.volume_ratio[q], 0.9);
      }
  });
}



// The stage works on a grid of its own; what it hands over must be in the order
// of the Scene's cells, which deal.II may have turned.
TEST_P(SiloTest, DisplacementIsContinuousAcrossCells)
{
  std::map<unsigned int, Tensor<1, 2>> displacement;
  double                               largest = 0.;
  fixture.for_each_cell([&](const auto &cell, const auto &cell_state) {
    for (const unsigned int v : cell->vertex_indices())
      {
        const auto &value = cell_state.displacement[v];
        const auto  found =
          displacement.emplace(cell->vertex_index(v), value).first;
        EXPECT_EQ(found->second, value);
        largest = std::max(largest, value.norm());
      }
  });
  EXPECT_GT(largest, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(
  Silos,
  SiloTest,
  testing::Combine(testing::Values(CellType::triangle, CellType::quadrilateral),
                   testing::Values(Formulation::plane_strain,
                                   Formulation::axisymmetric),
                   testing::Values(0., 1.1)));



namespace
{
  /// Displacement at the vertices and pressure at the quadrature points of a
  /// half filled rectangle, in order of their places.
  std::pair<std::vector<double>, std::vector<double>>
  results_by_place(const bool turns_empty_cells)
  {
    Rectangle rectangle;
    rectangle.cell_type = CellType::quadrilateral;
    rectangle.is_filled = [](const Point<2> &p) { return p[1] > 0.5; };
    Mesh<2> mesh        = rectangle.mesh();
    for (auto &cell : mesh.cells)
      if (turns_empty_cells && !cell.is_filled)
        std::rotate(cell.vertices.begin(),
                    cell.vertices.begin() + 2,
                    cell.vertices.end());
    for (unsigned int i = 0; i < rectangle.n_x; ++i)
      {
        const unsigned int first = (rectangle.n_x + 1) * rectangle.n_y / 2 + i;
        mesh.faces.push_back({{{first, first + 1}}, BoundaryRole::outlet});
      }
    StaticFixture fixture;
    fixture.run(mesh);

    std::map<std::pair<int, int>, double> settlement, pressures;
    fixture.for_each_cell([&](const auto &cell, const auto &cell_state) {
      const auto place = [](const Point<2> &p) {
        return std::make_pair(static_cast<int>(std::lround(1e6 * p[0])),
                              static_cast<int>(std::lround(1e6 * p[1])));
      };
      for (const unsigned int v : cell->vertex_indices())
        {
          settlement[place(cell->vertex(v))] = cell_state.displacement[v][1];
          const Point<2> reference(v % 2 == 0 ? 0.25 : 0.75,
                                   v / 2 == 0 ? 0.25 : 0.75);
          pressures[place(fixture.scene->mapping.transform_unit_to_real_cell(
            cell, reference))] = pressure(cell_state.stress[v]);
        }
    });
    std::pair<std::vector<double>, std::vector<double>> result;
    for (const auto &entry : settlement)
      result.first.push_back(entry.second);
    for (const auto &entry : pressures)
      result.second.push_back(entry.second);
    return result;
  }
} // namespace



// The stage works on a grid of its own. Empty cells that are given the other
// way round make deal.II turn the Scene's filled cells, but not those of that
// grid.
TEST(StaticStage, ReturnsResultsInTheOrderOfTheScenesCells)
{
  const auto [settlement, pressures]               = results_by_place(false);
  const auto [turned_settlement, turned_pressures] = results_by_place(true);
  ASSERT_EQ(settlement.size(), 15u);
  ASSERT_EQ(pressures.size(), 32u);
  for (unsigned int i = 0; i < settlement.size(); ++i)
    EXPECT_NEAR(settlement[i] / 1e-3, turned_settlement[i] / 1e-3, 1e-9);
  for (unsigned int i = 0; i < pressures.size(); ++i)
    EXPECT_NEAR(pressures[i] / 1e3, turned_pressures[i] / 1e3, 1e-9);
}



// Where Newton's method and relaxation are given too few steps, the load step
// is cut, and in the end the user is told where it stopped.
TEST(StaticStage, SaysWhereItStopped)
{
  StaticFixture fixture;
  fixture.silo.element_size                   = 0.2;
  fixture.parameters.maximum_iterations       = 1;
  fixture.parameters.maximum_relaxation_steps = 2;
  fixture.parameters.smallest_load_step       = 0.04;
  try
    {
      fixture.run_silo();
      FAIL() << "no error";
    }
  catch (const RunError &error)
    {
      const std::string message = error.what();
      EXPECT_NE(message.find("load of 0.05 of the weight"), std::string::npos)
        << message;
      EXPECT_NE(message.find("Maximum relaxation steps"), std::string::npos);
    }
}
