#include <sandglass/flow/particle_in_cell/volumetric_average.h>
#include <sandglass/particles/seeding.h>

#include <gtest/gtest.h>

#include "all_settings.h"
#include "random_engine.h"
#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  template <typename Setting>
  class LoosenedRateTest : public testing::Test
  {};

  TYPED_TEST_SUITE(LoosenedRateTest, AllSettings);



  /// The average and the sums that it is found from.
  template <typename Setting>
  struct AverageOfCells
  {
    using Geometry = CellGeometry<Setting::cell_type>;

    /// @param points  see CellIntegration.
    AverageOfCells(const StageFixture          &fixture,
                   const Geometry              &geometry,
                   const std::vector<Point<2>> &points = {})
      : fixture(fixture)
      , sums(geometry, 0.95 * fixture.material.density, points)
      , rates(*fixture.scene->nodes, geometry, fixture.material.density, true)
    {}

    void
    compute(const NodalField<2> &velocity)
    {
      const auto &blocks = fixture.stage->particles().blocks();
      sums.cells.compute(blocks);
      rates.cells->compute(blocks);
      rates.compute(blocks, sums, velocity);
    }

    const StageFixture        &fixture;
    NodalSums<Setting>         sums;
    VolumetricAverage<Setting> rates;
  };
} // namespace



// In distorted cells, by the force integration of the particles and the cell.
TYPED_TEST(LoosenedRateTest, OfAUniformRateIsThatRate)
{
  constexpr double a = 0.3, b = -0.1; // 1/s
  StageFixture     fixture;
  fixture.formulation = TypeParam::Kinematics::formulation;
  Rectangle rectangle;
  rectangle.cell_type = TypeParam::cell_type;
  rectangle.displaced = [](const Point<2> &p) {
    return Point<2>(p[0] + 0.07 * p[0] * p[1], p[1] - 0.05 * p[0]);
  };
  const auto  &stage   = fixture.start(rectangle.mesh());
  const double density = fixture.material.density;

  // From separated to stressed.
  auto                                   engine = random_engine();
  std::uniform_real_distribution<double> uniform;
  fixture.change_particles([&](auto, const auto &, auto state) {
    state[StageLayout::density] = density * (0.9 + 0.2 * uniform(engine));
  });

  const auto   velocity = fixture.at_nodes([&](const Point<2> &p) {
    return Tensor<1, 2>({a * p[0], b * p[1]});
  });
  const double expected = TypeParam::has_hoop_strain ? 2. * a + b : a + b;
  const CellGeometry<TypeParam::cell_type> geometry(*fixture.scene);
  for (const bool by_cell : {false, true})
    {
      using Configuration = InitialConfiguration<typename TypeParam::Kinematics,
                                                 TypeParam::cell_type>;
      AverageOfCells<TypeParam> average(
        fixture,
        geometry,
        by_cell ? Configuration(*fixture.scene, geometry).points :
                  std::vector<Point<2>>());
      average.compute(velocity);
      for (const auto &cell : stage.particles().owned_cells())
        EXPECT_NEAR(average.rates.rate_of_loosened(cell->active_cell_index()) /
                      expected,
                    1.,
                    1e-11);
    }
}



// The same flow at a pressure below and above ten times rho v^2, and at none.
TYPED_TEST(LoosenedRateTest, IsTakenWherePressureIsLowBesideInertia)
{
  constexpr double speed = 2.; // m/s
  StageFixture     fixture;
  fixture.formulation = TypeParam::Kinematics::formulation;
  Rectangle rectangle;
  rectangle.cell_type   = TypeParam::cell_type;
  const auto  &stage    = fixture.start(rectangle.mesh());
  const double density  = fixture.material.density;
  const auto   velocity = fixture.at_nodes([&](const Point<2> &) {
    return Tensor<1, 2>({0., speed});
  });
  const CellGeometry<TypeParam::cell_type> geometry(*fixture.scene);

  for (const double ratio : {0., 9.9, 10.1})
    {
      fixture.change_particles([&](const auto id, const auto &, auto state) {
        const bool is_loosened      = id % 2 == 0;
        state[StageLayout::density] = density * (is_loosened ? 0.99 : 1.01);
        for (const int c : {Component::xx, Component::yy, Component::zz})
          state[StageLayout::stress + c] = -ratio * density * speed * speed;
      });
      AverageOfCells<TypeParam> average(fixture, geometry);
      average.compute(velocity);
      for (const auto &cell : stage.particles().owned_cells())
        EXPECT_EQ(average.rates.has_loosened(cell->active_cell_index(),
                                             average.sums),
                  ratio < 10.)
          << "pressure over rho v^2 " << ratio;

      // Where all have loosened each keeps its own rate.
      fixture.change_particles([&](auto, const auto &, auto state) {
        state[StageLayout::density] = 0.99 * density;
      });
      average.compute(velocity);
      for (const auto &cell : stage.particles().owned_cells())
        EXPECT_FALSE(
          average.rates.has_loosened(cell->active_cell_index(), average.sums));
    }
}
