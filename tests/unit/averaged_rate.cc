#include <sandglass/flow/particle_in_cell/volumetric_average.h>
#include <sandglass/particles/seeding.h>

#include <gtest/gtest.h>

#include <cmath>

#include "all_settings.h"
#include "random_engine.h"
#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  template <typename Setting>
  class AveragedRateTest : public testing::Test
  {};

  TYPED_TEST_SUITE(AveragedRateTest, AllSettings);



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
      , sums(geometry, smallest_density, points)
      , rates(*fixture.scene->nodes, geometry, smallest_density, true)
    {}

    void
    compute(const NodalField<2> &velocity)
    {
      const auto &blocks = fixture.stage->particles().blocks();
      sums.cells.compute(blocks);
      if (rates.cells)
        rates.cells->compute(blocks);
      rates.compute(blocks, sums, velocity);
    }

    const StageFixture &fixture;
    const double        smallest_density = 0.95 * fixture.material.density;
    NodalSums<Setting>  sums;
    VolumetricAverage<Setting> rates;
  };
} // namespace



// In distorted cells, by the force integration of the particles and the cell.
TYPED_TEST(AveragedRateTest, OfAUniformRateIsThatRate)
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

  // From separated to dense.
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
        EXPECT_NEAR(average.rates.rate(cell->active_cell_index()) / expected,
                    1.,
                    1e-11);
    }
}



// The stiffness of an elastic pressure is symmetric, and not larger than
// without the average, also where cells hold little: else energy would come
// about.
TYPED_TEST(AveragedRateTest, IsASymmetricContraction)
{
  StageFixture fixture;
  fixture.formulation = TypeParam::Kinematics::formulation;
  Rectangle rectangle;
  rectangle.cell_type = TypeParam::cell_type;
  const auto &stage   = fixture.start(rectangle.mesh());

  auto                                   engine = random_engine();
  std::uniform_real_distribution<double> uniform;
  fixture.change_particles([&](auto, const auto &, auto state) {
    state[StageLayout::mass] *= std::pow(uniform(engine), 4);
  });
  const auto random_velocity = [&] {
    return fixture.at_nodes([&](const Point<2> &p) {
      return Tensor<1, 2>({p[0] * uniform(engine), uniform(engine)});
    });
  };
  const NodalField<2> velocities[] = {random_velocity(), random_velocity()};

  const CellGeometry<TypeParam::cell_type> geometry(*fixture.scene);
  using Configuration =
    InitialConfiguration<typename TypeParam::Kinematics, TypeParam::cell_type>;
  AverageOfCells<TypeParam> average(
    fixture, geometry, Configuration(*fixture.scene, geometry).points);
  std::array<std::vector<double>, 2> own, averaged;
  std::vector<double>                volumes;
  for (unsigned int i = 0; i < 2; ++i)
    {
      average.compute(velocities[i]);
      for (const auto &cell : stage.particles().owned_cells())
        {
          const unsigned int index = cell->active_cell_index();
          own[i].push_back(average.rates.own_rate(index));
          averaged[i].push_back(average.rates.rate(index));
          if (i == 0)
            volumes.push_back(average.sums.dense_volume(index));
        }
    }

  double power[2][2] = {}, power_of_own = 0.;
  for (unsigned int cell = 0; cell < volumes.size(); ++cell)
    {
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < 2; ++j)
          power[i][j] += volumes[cell] * own[i][cell] * averaged[j][cell];
      power_of_own += volumes[cell] * own[0][cell] * own[0][cell];
    }
  EXPECT_NEAR(power[0][1] / power[1][0], 1., 1e-11);
  EXPECT_GT(power[0][0], 0.);
  EXPECT_LT(power[0][0], power_of_own);
}
