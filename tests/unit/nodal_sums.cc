#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "random_engine.h"
#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  class NodalSumsTest : public testing::TestWithParam<CellType>
  {
  protected:
    /// Particles with random velocities on an irregular, half filled mesh.
    void
    start_with_random_velocities()
    {
      auto                                   engine = random_engine(3);
      std::uniform_real_distribution<double> number(-1., 1.);
      Rectangle                              rectangle;
      rectangle.cell_type = GetParam();
      rectangle.n_x = rectangle.n_y = 8;
      rectangle.is_filled           = [](const Point<2> &center) {
        return center[1] < 0.6;
      };
      rectangle.displaced = [&](const Point<2> &point) {
        const double x = number(engine), y = number(engine);
        return Point<2>(point[0] + 0.02 * x, point[1] + 0.02 * y);
      };
      fixture.start(rectangle.mesh());
      fixture.change_particles([&](auto, auto, auto state) {
        state[StageLayout::velocity]     = number(engine);
        state[StageLayout::velocity + 1] = number(engine);
      });
    }

    /// A column that collapses, until many particles have changed cell.
    void
    let_a_column_collapse(const Formulation formulation)
    {
      fixture.formulation = formulation;
      Rectangle rectangle;
      rectangle.cell_type = GetParam();
      rectangle.n_x = rectangle.n_y = 16;
      rectangle.is_filled           = [](const Point<2> &center) {
        return center[0] < 0.4 && center[1] < 0.6;
      };
      auto &stage = fixture.start(rectangle.mesh());
      for (unsigned int step = 0; step < 400; ++step)
        stage.step();
      const auto  &blocks    = stage.particles().blocks();
      unsigned int n_changed = 0;
      blocks.for_each([&](const ParticleSlot &slot) {
        n_changed += blocks.id(slot) / fixture.particles_per_cell != slot.cell;
      });
      ASSERT_GT(n_changed, 0.3 * blocks.n_particles());
    }

    /// All nodes' sums, node by node.
    std::vector<double>
    sums() const
    {
      const double *first = fixture.stage->nodal_fields().sums.at(0);
      return {first,
              first + NodalSum<2>::n_components *
                        fixture.scene->nodes->locally_owned_size()};
    }

    /// Largest difference over the largest value of its kind.
    static double
    relative_difference(const std::vector<double> &sums,
                        const std::vector<double> &others)
    {
      using Sum     = NodalSum<2>;
      using Kind    = std::pair<unsigned int, unsigned int>; // first, number
      double result = 0.;
      for (const auto &[first, n] : {Kind(Sum::mass, 1),
                                     Kind(Sum::momentum, 2),
                                     Kind(Sum::internal_force, 2),
                                     Kind(Sum::own_mass, 1),
                                     Kind(Sum::stiffness, 1)})
        {
          double largest = 0., difference = 0.;
          for (unsigned int i = 0; i < sums.size(); ++i)
            if (i % Sum::n_components >= first &&
                i % Sum::n_components < first + n)
              {
                largest = std::max(largest, std::abs(sums[i]));
                difference =
                  std::max(difference, std::abs(sums[i] - others[i]));
              }
          EXPECT_GT(largest, 0.);
          result = std::max(result, difference / largest);
        }
      return result;
    }

    /// Sum of one component over all nodes.
    double
    sum_over_nodes(const unsigned int component) const
    {
      double sum = 0.;
      for (unsigned int node = 0;
           node < fixture.scene->nodes->locally_owned_size();
           ++node)
        sum += fixture.stage->nodal_fields().sums.at(node)[component];
      return sum;
    }

    StageFixture fixture;
  };
} // namespace

TEST_P(NodalSumsTest, CarryMassAndMomentumExactly)
{
  start_with_random_velocities();
  double mass = 0., momentum_x = 0., momentum_y = 0., scale = 0.;
  fixture.for_each_particle([&](auto, auto, auto state) {
    mass += state[StageLayout::mass];
    momentum_x += state[StageLayout::mass] * state[StageLayout::velocity];
    momentum_y += state[StageLayout::mass] * state[StageLayout::velocity + 1];
    scale += state[StageLayout::mass];
  });
  EXPECT_NEAR(sum_over_nodes(NodalSum<2>::mass) / mass, 1., 1e-14);
  EXPECT_NEAR(sum_over_nodes(NodalSum<2>::momentum), momentum_x, 1e-14 * scale);
  EXPECT_NEAR(sum_over_nodes(NodalSum<2>::momentum + 1),
              momentum_y,
              1e-14 * scale);
}

TEST_P(NodalSumsTest, ParticlesMassIsThatOfTheFilledCells)
{
  start_with_random_velocities();
  double volume = 0.;
  for (const auto &cell : fixture.scene->triangulation.active_cell_iterators())
    if (fixture.scene->mesh.cells[cell->active_cell_index()].is_filled)
      volume += cell->measure();
  double mass = 0.;
  fixture.for_each_particle(
    [&](auto, auto, auto state) { mass += state[StageLayout::mass]; });
  EXPECT_NEAR(mass / (fixture.material.density * volume), 1., 1e-13);
}

TEST_P(NodalSumsTest, UniformStressIsInEquilibriumInside)
{
  // Patch test: in full cells the forces of a uniform stress cancel at inner
  // nodes. The irregular quadrilaterals need the particles as exact quadrature.
  Rectangle rectangle;
  rectangle.cell_type = GetParam();
  if (GetParam() == CellType::triangle)
    rectangle.displaced = [](const Point<2> &point) {
      return Point<2>(point[0] + 0.05 * std::sin(9. * point[1]),
                      point[1] + 0.05 * std::sin(7. * point[0]));
    };
  fixture.start(rectangle.mesh());
  fixture.change_particles([](auto, auto, auto state) {
    const double stress[4] = {-3e3, -5e3, -2e3, 1e3};
    std::copy_n(stress, 4, state.begin() + StageLayout::stress);
  });

  fixture.for_each_node([&](const Point<2> &vertex, const unsigned int node) {
    if (std::min({vertex[0], 1. - vertex[0], vertex[1], 1. - vertex[1]}) <
        1e-12)
      return;
    const double *sums = fixture.stage->nodal_fields().sums.at(node);
    EXPECT_NEAR(sums[NodalSum<2>::internal_force] / 5e3, 0., 1e-13);
    EXPECT_NEAR(sums[NodalSum<2>::internal_force + 1] / 5e3, 0., 1e-13);
  });
}

// A step leaves the next one's sums, to which particles that change cell are
// added one by one: the same as summing over all particles, but for rounding.
// If there were never even that, the stage would have summed anew.
TEST_P(NodalSumsTest, StepsKeepThoseOfTheParticlesAndReadingLeavesThem)
{
  for (const auto formulation :
       {Formulation::plane_strain, Formulation::axisymmetric})
    {
      let_a_column_collapse(formulation);
      double       largest     = 0.;
      unsigned int n_roundings = 0;
      for (unsigned int look = 0; look < 100; ++look)
        {
          fixture.stage->step();
          const std::vector<double> kept = sums();

          ASSERT_TRUE(fixture.is_finite());
          fixture.take_mean_forces();
          fixture.stage->view().totals();
          fixture.stage->view().critical_time_step(true);
          ASSERT_EQ(sums(), kept) << "reading has changed them";

          fixture.change_particles([](auto, auto, auto) {});
          const std::vector<double> anew = sums();
          n_roundings += anew != kept;
          largest = std::max(largest, relative_difference(kept, anew));
        }
      std::cout << "largest difference of the sums " << largest << ", any in "
                << n_roundings << " of 100 steps" << std::endl;
      EXPECT_LT(largest, 1e-12);
      EXPECT_GT(n_roundings, 0u);
    }
}

INSTANTIATE_TEST_SUITE_P(CellTypes,
                         NodalSumsTest,
                         testing::Values(CellType::triangle,
                                         CellType::quadrilateral));
