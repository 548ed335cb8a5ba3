#include <sandglass/flow/particle_in_cell/volumetric_average.h>
#include <sandglass/particles/seeding.h>

#include <gtest/gtest.h>

#include <cmath>

#include "all_settings.h"
#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  /// A square of 4 x 4 squares, whose right half holds `filling` times its
  /// mass, at rest.
  template <typename Setting>
  class OverfullCellsTest : public testing::Test
  {
  protected:
    using Geometry = CellGeometry<Setting::cell_type>;

    void
    start(const double filling)
    {
      fixture.formulation = Setting::Kinematics::formulation;
      Rectangle rectangle;
      rectangle.cell_type = Setting::cell_type;
      fixture.start(rectangle.mesh());
      fixture.change_particles([&](auto, const auto &position, auto state) {
        if (position[0] > 0.5)
          state[StageLayout::mass] *= filling;
      });
    }

    /// Call `function(average)` for the average of a velocity that is zero.
    template <typename Function>
    void
    with_average(const Function &function)
    {
      const auto    &blocks = fixture.stage->particles().blocks();
      const Geometry geometry(*fixture.scene);
      const auto     points =
        InitialConfiguration<typename Setting::Kinematics, Setting::cell_type>(
          *fixture.scene, geometry)
          .points;
      const double       smallest_density = 0.95 * fixture.material.density;
      NodalSums<Setting> sums(geometry, smallest_density, points);
      VolumetricAverage<Setting> average(*fixture.scene->nodes,
                                         geometry,
                                         smallest_density,
                                         true);
      average.overfull =
        std::make_unique<OverfullCells<Setting>>(*fixture.scene->nodes,
                                                 geometry,
                                                 blocks.cells(),
                                                 points,
                                                 fixture.material.density,
                                                 fixture.gravity.norm());
      sums.cells.compute(blocks);
      if (average.cells)
        average.cells->compute(blocks);
      average.compute(blocks, sums, fixture.at_nodes([](const Point<2> &) {
        return Tensor<1, 2>();
      }));
      function(average);
    }

    StageFixture fixture;
  };

  TYPED_TEST_SUITE(OverfullCellsTest, AllSettings);
} // namespace



// As at the start, and a little fuller: then nothing may change.
TYPED_TEST(OverfullCellsTest, CellsThatAreFullAreLeftAlone)
{
  for (const double filling : {1., 1.05})
    {
      this->start(filling);
      this->with_average([&](const auto &average) {
        for (const auto &cell : this->fixture.stage->particles().owned_cells())
          EXPECT_EQ(average.rate(cell->active_cell_index()), 0.);
      });
    }
}



// Full cells far from overfull ones keep their rate.
TYPED_TEST(OverfullCellsTest, OverfullCellsAreCompacted)
{
  constexpr double filling = 1.5;
  this->start(filling);
  this->with_average([&](const auto &average) {
    this->fixture.for_each_node(
      [&](const Point<2> &position, const unsigned int node) {
        if (std::abs(position[0] - 0.5) > 0.1)
          {
            EXPECT_NEAR(average.overfull->filling(node),
                        position[0] > 0.5 ? filling : 1.,
                        1e-12);
          }
      });
    for (const auto &cell : this->fixture.stage->particles().owned_cells())
      {
        const double rate = average.rate(cell->active_cell_index());
        if (cell->center()[0] > 0.75)
          {
            // Cells are squares, or halves of them.
            const double area = cell->n_vertices() == 4 ? 1. / 16. : 1. / 32.;
            EXPECT_NEAR(rate / relief_rate(filling, std::sqrt(area), 9.81),
                        -1.,
                        1e-12);
            EXPECT_LT(rate, 0.);
          }
        else if (cell->center()[0] < 0.25)
          {
            EXPECT_EQ(rate, 0.);
          }
      }
  });
}



// Separated particles count as if they were dense, and become denser.
TYPED_TEST(OverfullCellsTest, SeparatedParticlesAreCompacted)
{
  constexpr double filling = 1.5;
  this->fixture.parameters.relieve_overfull_cells =
    RelieveOverfullCells::always;
  this->start(filling);
  const double loose = 0.5 * this->fixture.material.density;
  this->fixture.change_particles([&](auto, const auto &, auto state) {
    state[StageLayout::density] = loose;
  });
  this->with_average([&](const auto &average) {
    for (const auto &cell : this->fixture.stage->particles().owned_cells())
      {
        const double area = cell->n_vertices() == 4 ? 1. / 16. : 1. / 32.;
        const double rate =
          average.separated_compaction(cell->active_cell_index());
        if (cell->center()[0] > 0.75)
          {
            EXPECT_NEAR(rate / relief_rate(filling, std::sqrt(area), 9.81),
                        1.,
                        1e-12);
          }
        else if (cell->center()[0] < 0.25)
          {
            EXPECT_EQ(rate, 0.);
          }
      }
  });
  this->fixture.stage->step();
  // Above the cells that feel the floor, which holds what falls.
  this->fixture.for_each_particle(
    [&](const auto &, const auto &position, const auto &state) {
      if (position[1] > 0.55 && position[0] > 0.8)
        {
          EXPECT_GT(state[StageLayout::density], loose * (1. + 1e-6));
        }
      else if (position[1] > 0.55 && position[0] < 0.2)
        {
          EXPECT_NEAR(state[StageLayout::density] / loose, 1., 1e-9);
        }
    });
}



TEST(OverfullCells, AreRelievedWhereTheParametersSay)
{
  StageFixture fixture;
  auto        &parameters  = fixture.parameters;
  auto        &feed        = fixture.feed;
  const auto   is_relieved = [&](const bool is_in_unequal_hexahedra,
                               const bool has_open_outlet) {
    return relieves_overfull_cells(parameters,
                                   feed,
                                   is_in_unequal_hexahedra,
                                   has_open_outlet);
  };
  EXPECT_TRUE(is_relieved(true, true));
  EXPECT_FALSE(is_relieved(true, false));
  EXPECT_FALSE(is_relieved(false, true));
  feed.kind = FeedKind::rain;
  EXPECT_FALSE(is_relieved(false, true));
  feed.kind = FeedKind::level;
  EXPECT_TRUE(is_relieved(false, true));
  EXPECT_FALSE(is_relieved(false, false));
  parameters.relieve_overfull_cells = RelieveOverfullCells::where_fed;
  EXPECT_TRUE(is_relieved(false, true));
  EXPECT_FALSE(is_relieved(false, false));
  feed.kind = FeedKind::none;
  EXPECT_FALSE(is_relieved(true, true));
  parameters.relieve_overfull_cells = RelieveOverfullCells::never;
  EXPECT_FALSE(is_relieved(true, true));
  parameters.relieve_overfull_cells = RelieveOverfullCells::always;
  EXPECT_TRUE(is_relieved(false, true));
  EXPECT_TRUE(is_relieved(false, false));
}
