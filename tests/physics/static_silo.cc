#include <sandglass/base/exceptions.h>

#include <gtest/gtest.h>

#include <iostream>
#include <map>

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
  const double mu        = fixture.walls.friction_coefficient();
  const double scale     = fixture.weight();
  unsigned int n_sliding = 0;
  for (const WallForce &force : fixture.state.wall_forces)
    {
      const double limit = mu * std::max(force.normal_force, 0.);
      EXPECT_LE(std::abs(force.tangential_force) / scale,
                limit / scale + 1e-12);
      n_sliding += std::abs(force.tangential_force) > (1. - 1e-9) * limit &&
                   force.normal_force > 0.;
      // settling material is held back
      if (force.role == BoundaryRole::wall)
        {
          EXPECT_GE(force.tangential_force / scale, -1e-12);
        }
    }
  EXPECT_GT(n_sliding, 0u);
}



TEST_P(SiloTest, StressIsAdmissible)
{
  const DruckerPrager law   = fixture.material.drucker_prager();
  const double        scale = 1500. * 9.81 * fixture.silo.fill_height();
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



// Where Newton is given too few iterations, the load step is cut, and in the
// end the user is told where it stopped.
TEST(StaticStage, SaysWhereItStopped)
{
  StaticFixture fixture;
  fixture.silo.element_size             = 0.2;
  fixture.parameters.maximum_iterations = 1;
  fixture.parameters.smallest_load_step = 0.04;
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
      EXPECT_NE(message.find("Maximum iterations"), std::string::npos);
    }
}
