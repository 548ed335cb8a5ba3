#include <sandglass/output/particle_totals.h>
#include <sandglass/output/wall_tractions.h>
#include <sandglass/scene/make_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "rest.h"
#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  Tensor<1, dim>
  force_on_material(const WallForce<2> &force)
  {
    return -force.normal_force * force.normal +
           force.tangential_force * wall_tangent(force.normal);
  }



  using Lip  = WallParameters::OutletLip;
  using Silo = std::tuple<CellType, Formulation, double, bool, Lip>;

  /// A silo that has just begun to flow.
  class WallBalance : public testing::TestWithParam<Silo>
  {
  protected:
    WallBalance()
    {
      silo.cell_type           = std::get<0>(GetParam());
      fixture.formulation      = std::get<1>(GetParam());
      silo.hopper_height       = std::get<2>(GetParam());
      silo.is_symmetric        = std::get<3>(GetParam());
      fixture.walls.outlet_lip = std::get<4>(GetParam());
      silo.wall_height         = 1.7 - silo.hopper_height / 2.;
      silo.element_size        = 0.1;
      if (!silo.is_symmetric)
        silo.outlet_eccentricity = 0.3;
      fixture.start(mesh_silo<2>(silo));

      start_from_rest(fixture);
      run(0.05);
      fixture.take_mean_forces();
    }

    void
    run(const double duration)
    {
      const double end = fixture.stage->view().clock().time + duration;
      while (fixture.stage->view().clock().time < end)
        fixture.stage->step();
    }

    ParticleTotals
    totals() const
    {
      return {*fixture.stage, fixture.elasticity()};
    }

    /// In N s, summed over steps.
    struct Impulses
    {
      Tensor<1, dim> walls, momentum;
      double         weight     = 0.;
      unsigned int   n_steps    = 0;
      unsigned int   n_left_out = 0;
    };

    /// All steps but those in which particles leave the grid, since the totals
    /// don't tell what momentum they take along: beside a free lip single ones
    /// pass the fall region's side.
    Impulses
    add_up_steps(const double duration)
    {
      // The totals are those of the whole silo.
      const double factor = fixture.scene->symmetry_factor;
      Impulses     sum;
      const double end = fixture.stage->view().clock().time + duration;
      while (fixture.stage->view().clock().time < end)
        {
          const ParticleTotals before = totals();
          fixture.stage->step();
          const ParticleTotals after = totals();
          const auto forces = fixture.take_mean_forces();
          ++sum.n_steps;
          if (after.mass_removed != before.mass_removed)
            {
              ++sum.n_left_out;
              continue;
            }
          const double time_step = fixture.stage->view().clock().time_step;
          for (const WallForce<2> &force : forces)
            sum.walls += time_step * force_on_material(force);
          const double mass = before.mass() - before.mass_removed;
          sum.weight += time_step * mass / factor * 9.81;
          Tensor<1, dim> change = after.momentum - before.momentum;
          change[1] /= factor;
          sum.momentum += change;
        }
      return sum;
    }

    StageFixture    fixture;
    SceneParameters silo;
  };
} // namespace



// The forces are recorded as impulses, and step 6 gives the particles just the
// momentum that the nodes get: impulse of the walls and weight make up the
// change of momentum to rounding.
TEST_P(WallBalance, ForcesWeightAndMomentumBalance)
{
  const Impulses sum    = add_up_steps(0.1);
  const double   weight = sum.weight;
  std::cout << "walls' share of the weight " << sum.walls[1] / weight
            << ", error of the balance "
            << (sum.walls[1] - weight - sum.momentum[1]) / weight << std::endl;
  EXPECT_GT(std::abs(sum.momentum[1] / weight), 1e-3)
    << "the balance is not that of a silo at rest";
  EXPECT_NEAR((sum.walls[1] - sum.momentum[1]) / weight, 1., 1e-10);
  // In a ring, hoop stress acts along the radius too.
  if (fixture.formulation == Formulation::plane_strain)
    {
      EXPECT_NEAR((sum.walls[0] - sum.momentum[0]) / weight, 0., 1e-10);
    }
  EXPECT_LT(sum.n_left_out, sum.n_steps / 5);
}



TEST_P(WallBalance, TractionsOverTheWallsMakeUpTheForces)
{
  run(0.02);
  const OutputParameters output;
  const WallTractions    observer(output,
                               *fixture.scene,
                               fixture.material,
                               fixture.walls);
  const auto             forces = fixture.take_mean_forces();

  Tensor<1, dim> expected, found;
  double         largest = 0.;
  for (const WallForce<2> &force : forces)
    if (is_wall(force.role))
      {
        expected += force_on_material(force);
        largest += force_on_material(force).norm();
      }
  // The piecewise linear tractions' integral over the walls' lines.
  const auto tractions = observer.collect(forces);
  for (unsigned int i = 0; i + 1 < tractions.size(); ++i)
    {
      const WallTraction &a = tractions[i], &b = tractions[i + 1];
      if (a.force.role != b.force.role || a.place.line != b.place.line)
        continue;
      const double length = b.place.arc_length - a.place.arc_length;
      EXPECT_NEAR(length, a.force.position.distance(b.force.position), 1e-12);
      for (const WallTraction *end : {&a, &b})
        {
          // half of the edge, of the ring at a third of it from the end
          const double other =
            end == &a ? b.force.position[0] : a.force.position[0];
          const double area =
            fixture.formulation == Formulation::plane_strain ?
              length / 2. :
              length * numbers::PI * (2. * end->force.position[0] + other) / 3.;
          found += area * (-end->normal * end->force.normal +
                           end->tangential * wall_tangent(end->force.normal));
        }
    }
  EXPECT_NEAR((found - expected).norm() / largest, 0., 1e-12);
}



INSTANTIATE_TEST_SUITE_P(
  Halves,
  WallBalance,
  testing::Combine(testing::Values(CellType::triangle, CellType::quadrilateral),
                   testing::Values(Formulation::plane_strain,
                                   Formulation::axisymmetric),
                   testing::Values(0., 1.1),
                   testing::Values(true),
                   testing::Values(Lip::floor, Lip::free)));

INSTANTIATE_TEST_SUITE_P(
  Wholes,
  WallBalance,
  testing::Combine(testing::Values(CellType::triangle, CellType::quadrilateral),
                   testing::Values(Formulation::plane_strain),
                   testing::Values(0., 1.1),
                   testing::Values(false),
                   testing::Values(Lip::floor, Lip::free)));
