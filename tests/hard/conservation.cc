#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  /// A disc that turns with 1 rad/s in the middle of an empty grid.
  class SpinningDisc
  {
  public:
    static constexpr double radius = 1.;

    SpinningDisc(const CellType cell_type, const unsigned int cells_per_radius)
    {
      fixture.gravity             = {};
      fixture.parameters.end_time = 1e3;
      Rectangle rectangle;
      rectangle.cell_type = cell_type;
      rectangle.left      = BoundaryRole::wall;
      rectangle.lower     = Point<2>(-2. * radius, -2. * radius);
      rectangle.upper     = Point<2>(2. * radius, 2. * radius);
      rectangle.n_x = rectangle.n_y = 4 * cells_per_radius;
      rectangle.is_filled           = [](const Point<2> &center) {
        return center.norm() < radius;
      };
      fixture.start(rectangle.mesh());
      fixture.change_particles([](auto, const auto &position, auto state) {
        state[StageLayout::velocity]     = -position[1];
        state[StageLayout::velocity + 1] = position[0];
      });
    }

    Tensor<1, 2>
    momentum() const
    {
      Tensor<1, 2> sum;
      fixture.for_each_particle([&sum](auto, auto &, auto state) {
        for (unsigned int d = 0; d < 2; ++d)
          sum[d] += state[StageLayout::mass] * state[StageLayout::velocity + d];
      });
      return sum;
    }

    /// Angular momentum about the origin, in kg m^2/s per metre of depth.
    double
    angular_momentum() const
    {
      double sum = 0.;
      fixture.for_each_particle([&sum](auto, const auto &x, auto state) {
        sum +=
          state[StageLayout::mass] * (x[0] * state[StageLayout::velocity + 1] -
                                      x[1] * state[StageLayout::velocity]);
      });
      return sum;
    }

    StageFixture fixture;
  };

  class Conservation : public testing::TestWithParam<CellType>
  {};
} // namespace



// If particles take the grid's velocity in step 6 instead of its change, more
// than half of the angular momentum is lost.
TEST_P(Conservation, ASpinningDiscKeepsItsAngularMomentum)
{
  std::array<double, 2> errors;
  for (const unsigned int mesh : {0u, 1u})
    {
      SpinningDisc disc(GetParam(), 8u << mesh);
      const double start = disc.angular_momentum();
      while (disc.fixture.stage->view().clock().time < 1.)
        disc.fixture.stage->step();
      errors[mesh]          = std::abs(disc.angular_momentum() / start - 1.);
      const double momentum = disc.momentum().norm() / start;
      std::cout << (8u << mesh)
                << " cells per radius, after 1 rad: error of the "
                << "angular momentum " << errors[mesh] << ", momentum / L "
                << momentum << std::endl;
      EXPECT_LT(momentum, 1e-12);
    }
  EXPECT_LT(errors[1], 0.01);
}



namespace
{
  /// A bar of 16 cells, held at its ends in uniaxial strain, swings in its
  /// first mode under a pressure that keeps it elastic.
  class SwingingBar
  {
  public:
    static constexpr double       h          = 0.1;
    static constexpr unsigned int n_elements = 16;

    SwingingBar(const CellType cell_type, const double relative_time_step)
    {
      constexpr double volume_ratio  = 0.99;
      fixture.material.poisson_ratio = 0.;
      fixture.parameters.end_time    = 1e3;
      fixture.gravity                = {};
      fixture.walls.normal_condition =
        WallParameters::NormalCondition::acceleration;
      const double wave_speed = fixture.elasticity().wave_speed(
        fixture.material.density / volume_ratio);
      period = 2. * n_elements * h / wave_speed;
      fixture.set_time_step(relative_time_step * h / wave_speed);

      Rectangle rectangle;
      rectangle.cell_type = cell_type;
      rectangle.n_x       = n_elements;
      rectangle.n_y       = 2;
      rectangle.upper     = Point<2>(n_elements * h, 2. * h);
      rectangle.left = rectangle.right = BoundaryRole::axis;
      rectangle.bottom = rectangle.top = BoundaryRole::axis;
      fixture.start(rectangle.mesh());
      fixture.stage->start_from(
        [](const unsigned int, const Point<2> &) {
          InitialState<2> state{{}, {}, volume_ratio};
          state.stress << -50., -50., -50., 0.; // Pa
          return state;
        },
        {});
      fixture.change_particles([&](auto, const auto &x, auto state) {
        state[StageLayout::velocity] = 1e-6 * wave_speed * mode(x[0]);
      });
    }

    /// Largest kinetic energy over a period, in J per metre of depth.
    double
    kinetic_energy_of_a_period()
    {
      const double end     = fixture.stage->view().clock().time + period;
      double       largest = 0.;
      while (fixture.stage->view().clock().time < end)
        {
          fixture.stage->step();
          double energy = 0.;
          fixture.for_each_particle([&energy](auto, auto &, auto state) {
            energy += 0.5 * state[StageLayout::mass] *
                      state[StageLayout::velocity] *
                      state[StageLayout::velocity];
          });
          largest = std::max(largest, energy);
        }
      return largest;
    }

    StageFixture fixture;
    double       period; ///< in s

  private:
    static double
    mode(const double x)
    {
      return std::sin(numbers::PI * x / (n_elements * h));
    }
  };
} // namespace



// If particles take the grid's velocity, as above, nine tenths of the energy
// are lost at the largest step, and all but 3e-4 at the smallest.
TEST_P(Conservation, AnElasticBarKeepsItsEnergyOverTenPeriods)
{
  for (const double relative_time_step : {1., 0.5, 0.25})
    {
      SwingingBar  bar(GetParam(), relative_time_step);
      const double first = bar.kinetic_energy_of_a_period();
      double       last  = first;
      for (unsigned int i = 1; i < 10; ++i)
        last = bar.kinetic_energy_of_a_period();
      std::cout << "dt C / h = " << relative_time_step
                << ": energy in the tenth period over the first "
                << last / first << std::endl;
      EXPECT_NEAR(last / first, 1., 0.01);
    }
}

INSTANTIATE_TEST_SUITE_P(CellTypes,
                         Conservation,
                         testing::Values(CellType::triangle,
                                         CellType::quadrilateral));
