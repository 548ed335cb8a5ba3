#include <sandglass/material/drucker_prager.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>

#include "../random_engine.h"
#include "../stage_fixture.h"

using namespace Sandglass;

// Trial stresses around the apex, of all sizes: near it and far from it, in
// tension, compression, and within rounding of p = 0.
TEST(Tension, StressReturnsToTheConeOrItsApex)
{
  auto                                   engine = random_engine();
  std::uniform_real_distribution<double> component(-1., 1.),
    exponent(-60., 60.);
  double       largest_excess = 0.;
  unsigned int n_separated    = 0;
  for (const double friction_angle : {0., 0.1, 0.4, 0.8, 1.5})
    {
      const DruckerPrager law(Elasticity(1e6, 0.3), friction_angle);
      for (unsigned int i = 0; i < 100000; ++i)
        {
          const double           size = std::pow(10., exponent(engine));
          SymmetricComponents<4> stress;
          for (unsigned int c = 0; c < 4; ++c)
            stress[c] = size * component(engine);
          if (i % 4 == 0) // nearly on the plane p = 0
            stress =
              deviator(stress) - 1e-16 * size * component(engine) *
                                   SymmetricComponents<4>(1., 1., 1., 0.);
          const double dissipation = law.project(stress);
          n_separated += stress.isZero(0.) ? 1 : 0;
          ASSERT_TRUE(stress.allFinite());
          ASSERT_GE(dissipation, 0.);
          ASSERT_GE(pressure(stress), 0.);
          largest_excess =
            std::max(largest_excess, law.yield_function(stress) / size);
        }
    }
  std::cout << "largest yield function / trial stress " << largest_excess
            << ", separated " << n_separated << " of 500000" << std::endl;
  EXPECT_LT(largest_excess, 1e-13);
  EXPECT_GT(n_separated, 200000u);
}



namespace
{
  /// Of a cell type, and a parameter `Loosest density`.
  class PulledBlock
    : public testing::TestWithParam<std::tuple<CellType, double>>
  {};
} // namespace



// A block that is pulled apart and pushed together again: no stress while it is
// less dense than the loosest that carries any, whatever the way back, and
// pressure once it is denser. With the paper's density it would have stress as
// soon as it is pushed.
TEST_P(PulledBlock, HasNoStressUntilItIsCompactedAgain)
{
  const auto &[cell_type, loosest_density] = GetParam();
  StageFixture fixture;
  fixture.gravity                    = {};
  fixture.parameters.loosest_density = loosest_density;
  fixture.parameters.end_time        = 1e3;
  fixture.parameters.time_step_text  = "1e-4";
  Rectangle rectangle;
  rectangle.cell_type = cell_type;
  rectangle.left      = BoundaryRole::wall;
  rectangle.lower     = Point<2>(-1., -1.);
  rectangle.n_x = rectangle.n_y = 20;
  rectangle.is_filled           = [](const Point<2> &center) {
    return std::max(std::abs(center[0]), std::abs(center[1])) < 0.5;
  };
  auto &stage = fixture.start(rectangle.mesh());

  double largest_loose = 0., smallest_density = 1e300, largest_pressure = 0.;
  for (unsigned int step = 0; step < 3000; ++step)
    {
      const double rate = step < 1000 ? 1. : -1.; // strain rate in 1/s
      fixture.change_particles([&](auto, const auto &position, auto state) {
        for (unsigned int d = 0; d < 2; ++d)
          state[StageLayout::velocity + d] = rate * position[d];
      });
      stage.step();
      fixture.for_each_particle([&](auto, const auto &, auto state) {
        const Eigen::Map<const SymmetricComponents<4>> stress(
          &state[StageLayout::stress]);
        if (state[StageLayout::density] < loosest_density * 1500.)
          largest_loose = std::max(largest_loose, stress.norm());
        smallest_density =
          std::min(smallest_density, state[StageLayout::density]);
        largest_pressure = std::max(largest_pressure, pressure(stress));
      });
    }
  std::cout << "largest stress of loose material " << largest_loose
            << " Pa, smallest density " << smallest_density
            << " kg/m^3, largest pressure " << largest_pressure << " Pa"
            << std::endl;
  EXPECT_EQ(largest_loose, 0.);
  EXPECT_LT(smallest_density, 0.85 * 1500.);
  EXPECT_GT(largest_pressure, 1e4);
}

INSTANTIATE_TEST_SUITE_P(
  CellTypes,
  PulledBlock,
  testing::Combine(testing::Values(CellType::triangle, CellType::quadrilateral),
                   testing::Values(1., 0.95)));
