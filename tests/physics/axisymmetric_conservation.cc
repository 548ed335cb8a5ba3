#include <sandglass/scene/make_mesh.h>

#include <gtest/gtest.h>

#include <cmath>

#include "rest.h"
#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  constexpr double g = 9.81;

  struct Totals
  {
    double mass            = 0.;
    double axial_momentum  = 0.;
    double smallest_radius = 1e300;
    bool   is_finite       = true;
  };

  Totals
  totals_of(const StageFixture &fixture)
  {
    Totals totals;
    fixture.for_each_particle([&](auto, const auto &position, auto state) {
      totals.mass += state[StageLayout::mass];
      totals.axial_momentum +=
        state[StageLayout::mass] * state[StageLayout::velocity + 1];
      totals.smallest_radius = std::min(totals.smallest_radius, position[0]);
      double sum             = position[0] + position[1];
      for (unsigned int i = 0; i < StageLayout::n_properties; ++i)
        sum += state[i];
      totals.is_finite = totals.is_finite && std::isfinite(sum);
    });
    return totals;
  }

  /// Axial impulse of all walls on the material since the last call, per s.
  double
  lift(StageFixture &fixture)
  {
    double sum = 0.;
    for (const MeanWallForce &force : fixture.take_mean_forces())
      sum += force.force[1];
    return sum;
  }

  class AxisymmetricConservation : public testing::TestWithParam<CellType>
  {
  protected:
    AxisymmetricConservation()
    {
      fixture.formulation = Formulation::axisymmetric;
    }

    /// The paper's cylinder on its coarse mesh, from rest.
    void
    start_silo(SceneParameters &silo)
    {
      silo.half_width        = 0.12;
      silo.wall_height       = 0.27;
      silo.outlet_half_width = 0.05;
      silo.fall_region_depth = 0.15;
      silo.element_size      = 0.0125;
      silo.cell_type         = GetParam();
      fixture.start(mesh_silo<2>(silo));

      start_from_rest(fixture);
    }

    StageFixture fixture;
  };
} // namespace



// Free fall of each single particle is tested in free_fall.cc.
TEST_P(AxisymmetricConservation, FreeFallKeepsMassAndGainsMomentumByGravity)
{
  fixture.parameters.time_step_text = "1e-3";
  Rectangle rectangle;
  rectangle.cell_type = GetParam();
  rectangle.upper     = Point<2>(0.5, 2.);
  rectangle.n_x       = 5;
  rectangle.n_y       = 20;
  rectangle.is_filled = [](const Point<2> &center) { return center[1] > 1.5; };
  auto        &stage  = fixture.start(rectangle.mesh());
  const Totals before = totals_of(fixture);
  EXPECT_NEAR(before.mass / (1500. * numbers::PI * 0.25 * 0.5), 1., 1e-13);

  double largest_error = 0.;
  for (unsigned int step = 1; step <= 400; ++step)
    {
      stage.step();
      const Totals totals = totals_of(fixture);
      EXPECT_NEAR(totals.mass / before.mass, 1., 1e-14);
      const double expected = -before.mass * g * 1e-3 * step;
      largest_error         = std::max(largest_error,
                               std::abs(totals.axial_momentum / expected - 1.));
    }
  std::cout << "largest error of the momentum / momentum " << largest_error
            << std::endl;
  // 400 sums of rounded numbers
  EXPECT_LT(largest_error, 400 * 1e-16 * 10.);
}



// Internal forces cancel, so that axial momentum changes by gravity and walls
// alone. Within 200 steps nothing has fallen out of the grid.
TEST_P(AxisymmetricConservation, MomentumOfTheFlowIsTheImpulseOfItsForces)
{
  SceneParameters silo;
  start_silo(silo);
  auto        &stage   = *fixture.stage;
  const Totals before  = totals_of(fixture);
  Totals       last    = before;
  double largest_error = 0., largest_mass_error = 0., smallest_radius = 1e300;
  lift(fixture);
  for (unsigned int step = 0; step < 200; ++step)
    {
      stage.step();
      const Totals totals  = totals_of(fixture);
      const double forces  = lift(fixture) - totals.mass * g;
      const double impulse = forces * stage.view().clock().time_step;
      largest_error        = std::max(largest_error,
                               std::abs(totals.axial_momentum -
                                        last.axial_momentum - impulse));
      largest_mass_error =
        std::max(largest_mass_error, std::abs(totals.mass / before.mass - 1.));
      smallest_radius = std::min(smallest_radius, totals.smallest_radius);
      ASSERT_TRUE(totals.is_finite) << "step " << step;
      last = totals;
    }
  ASSERT_EQ(stage.removed_mass().discharged, 0.);
  ASSERT_EQ(stage.removed_mass().lost, 0.);

  const double fall = before.mass * g * stage.view().clock().time;
  std::cout << "momentum / (m g t) at " << stage.view().clock().time << " s "
            << last.axial_momentum / fall
            << "\nlargest error of a step / (m g t)  " << largest_error / fall
            << "\nlargest error of the mass          " << largest_mass_error
            << "\nsmallest radius / element size     "
            << smallest_radius / *silo.element_size << std::endl;
  EXPECT_LT(last.axial_momentum / fall, -0.01) << "it doesn't flow";
  EXPECT_LT(largest_error / fall, 1e-13);
  EXPECT_LT(largest_mass_error, 1e-14);
  EXPECT_GT(smallest_radius, 0.);
}



// The nodes' hoop forces have 1 / r. Particles that the static stage's
// displacement puts on the axis itself (where only rounding can bring them)
// must not blow up.
TEST_P(AxisymmetricConservation, ParticlesOnTheAxisStayFinite)
{
  Rectangle rectangle;
  rectangle.cell_type                = GetParam();
  auto                        &stage = fixture.start(rectangle.mesh());
  std::map<unsigned int, bool> is_at_axis;
  for (const auto &cell : fixture.scene->triangulation.active_cell_iterators())
    for (const unsigned int face : cell->face_indices())
      if (cell->at_boundary(face) &&
          cell->face(face)->boundary_id() == boundary_id(BoundaryRole::axis))
        is_at_axis[cell->active_cell_index()] = true;

  const SymmetricComponents<4> stress(-1e3, -1e3, -1e3, 0.);
  stage.start_from(
    [&](const unsigned int cell, const Point<2> &reference) {
      auto iterator = fixture.scene->triangulation.begin_active();
      std::advance(iterator, cell);
      const Point<2> position =
        fixture.scene->mapping.transform_unit_to_real_cell(iterator, reference);
      const double radius = is_at_axis[cell] ? position[0] : 0.;
      return InitialState<2>{Tensor<1, 2>({-radius, 0.}), stress, 0.999};
    },
    {});
  const double wave_speed = fixture.elasticity().wave_speed(1500.);
  for (unsigned int step = 0; step < 100; ++step)
    {
      stage.step();
      ASSERT_TRUE(totals_of(fixture).is_finite) << "step " << step;
      ASSERT_LT(stage.view().totals().largest_speed / wave_speed, 0.1)
        << "step " << step;
    }
  const double smallest_radius = totals_of(fixture).smallest_radius;
  std::cout << "smallest radius " << smallest_radius
            << " m, largest speed / wave speed "
            << stage.view().totals().largest_speed / wave_speed << std::endl;
  EXPECT_GT(smallest_radius, 0.);
}

INSTANTIATE_TEST_SUITE_P(CellTypes,
                         AxisymmetricConservation,
                         testing::Values(CellType::triangle,
                                         CellType::quadrilateral));
