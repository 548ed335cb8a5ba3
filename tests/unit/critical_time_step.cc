#include <sandglass/continuum/axisymmetric.h>
#include <sandglass/continuum/plane_strain.h>
#include <sandglass/flow/particle_in_cell/critical_time_step.h>
#include <sandglass/flow/particle_in_cell/law_adapter.h>
#include <sandglass/material/drucker_prager.h>

#include <gtest/gtest.h>

#include <cmath>

#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  /// The critical step with enough iterations for the converged eigenvalue.
  template <typename Kinematics>
  double
  largest_stable_step(StageFixture &fixture)
  {
    using Quadrilaterals = Setting<Kinematics, CellType::quadrilateral>;
    const auto &stage    = *fixture.stage;
    const auto &blocks   = stage.particles().blocks();
    const CellGeometry<CellType::quadrilateral> geometry(*fixture.scene);
    NodalSums<Quadrilaterals>                   cells(geometry, 0., {});
    cells.cells.compute(blocks);
    MassMatrix<Quadrilaterals> mass_matrix(
      *fixture.scene->nodes,
      geometry,
      fixture.parameters.consistent_mass_share);
    mass_matrix.assemble(blocks, cells, stage.nodal_fields().sums);
    const LawAdapter<Quadrilaterals, DruckerPrager> law(fixture.material,
                                                        fixture.parameters,
                                                        geometry);
    CriticalTimeStep<Quadrilaterals> critical(law, geometry, *fixture.scene);
    critical.assemble(blocks, cells);
    return critical.compute(blocks,
                            cells,
                            mass_matrix,
                            stage.wall_contact(),
                            stage.nodal_fields().sums,
                            60);
  }

  /// Critical step, times wave speed over element size, of a strip of squares
  /// one cell wide, with free ends.
  double
  relative_critical_step(const unsigned int particles_per_cell,
                         const Formulation  formulation)
  {
    constexpr double h = 0.1;
    StageFixture     fixture;
    fixture.material.poisson_ratio = 0.;
    fixture.particles_per_cell     = particles_per_cell;
    fixture.formulation            = formulation;
    Rectangle rectangle;
    rectangle.cell_type = CellType::quadrilateral;
    // Far from the axis a ring is a strip.
    const double x  = formulation == Formulation::axisymmetric ? 1e4 : 0.;
    rectangle.lower = Point<2>(x, 0.);
    rectangle.upper = Point<2>(x + h, 40 * h);
    rectangle.n_x   = 1;
    rectangle.n_y   = 40;
    fixture.start(rectangle.mesh());
    const double step = formulation == Formulation::plane_strain ?
                          largest_stable_step<PlaneStrain>(fixture) :
                          largest_stable_step<Axisymmetric>(fixture);
    return step * fixture.elasticity().wave_speed(fixture.material.density) / h;
  }
} // namespace

// On an infinite strip with particles at the cells' centres the eigenvalue of
// the wave number k is (C / h)^2 sin^2(k h), so that the critical step is 2
// h/C. With two particles in a row, at the quarter points, it is (C / h)^2 (1 -
// cos k h) (5 + 3 cos k h) / 4, at most 4/3 (C / h)^2.

TEST(CriticalTimeStep, OfOneParticleInACell)
{
  const double step = relative_critical_step(1, Formulation::plane_strain);
  EXPECT_NEAR(step, 2., 0.01);
  EXPECT_NEAR(relative_critical_step(1, Formulation::axisymmetric), step, 1e-3);
}

TEST(CriticalTimeStep, OfParticlesAtTheQuarterPoints)
{
  const double step = relative_critical_step(4, Formulation::plane_strain);
  EXPECT_NEAR(step, std::sqrt(3.), 0.01);
  EXPECT_NEAR(relative_critical_step(4, Formulation::axisymmetric), step, 1e-3);
}

TEST(CriticalTimeStep, GrowsWithTheInverseRootOfTheStiffness)
{
  const auto step = [](const double young_modulus) {
    StageFixture fixture;
    fixture.material.young_modulus = young_modulus;
    return fixture.start(Rectangle().mesh()).view().critical_time_step(true);
  };
  EXPECT_NEAR(step(1e6) / step(4e6), 2., 1e-8);
}

// A particle next to the axis has a hoop strain of the order of that of its
// cell, since the nodes on the axis can't leave it: it must not shrink the
// step.
TEST(CriticalTimeStep, DoesNotVanishNextToTheAxis)
{
  StageFixture fixture;
  fixture.formulation        = Formulation::axisymmetric;
  fixture.particles_per_cell = 4;
  Rectangle rectangle;
  rectangle.cell_type = CellType::quadrilateral;
  auto        &stage  = fixture.start(rectangle.mesh());
  const double before = largest_stable_step<Axisymmetric>(fixture);

  const CellGeometry<CellType::quadrilateral> geometry(*fixture.scene);
  stage.edit_particles([&](auto &handler) {
    for (const auto &cell : stage.particles().owned_cells())
      if (cell->center()[0] < 0.25)
        {
          auto           particle = handler.particles_in_cell(cell).begin();
          const Point<2> location(1e-4, cell->center()[1]);
          particle->set_location(location);
          particle->set_reference_location(
            geometry.shape(cell->active_cell_index()).to_reference(location));
        }
  });
  const double after        = largest_stable_step<Axisymmetric>(fixture);
  const double time_of_wave = 0.25 / fixture.elasticity().wave_speed(1500.);
  std::cout << "critical step C / h, as seeded " << before / time_of_wave
            << ", with particles next to the axis " << after / time_of_wave
            << std::endl;
  EXPECT_NEAR(after / before, 1., 0.2);
}

// Separated material is not stiff, but may be so again before the next look.
TEST(CriticalTimeStep, AutomaticStepIsNotLongerThanAsSeeded)
{
  StageFixture fixture;
  auto        &stage  = fixture.start(Rectangle().mesh());
  const double seeded = stage.view().critical_time_step(true);
  fixture.change_particles(
    [](auto, auto, auto state) { state[StageLayout::density] = 1000.; });
  EXPECT_EQ(stage.view().critical_time_step(true),
            std::numeric_limits<double>::infinity());
  stage.step();
  EXPECT_NEAR(stage.view().clock().time_step / seeded,
              fixture.parameters.time_step_safety,
              1e-12);
}
