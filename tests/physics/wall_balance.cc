#include <sandglass/observers/particle_totals.h>
#include <sandglass/observers/wall_tractions.h>
#include <sandglass/scene/make_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "rest.h"
#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  using Silo = std::tuple<CellType, Formulation, double, bool>;

  /// A silo that has just begun to flow; nothing leaves the grid yet.
  class WallBalance : public testing::TestWithParam<Silo>
  {
  protected:
    WallBalance()
    {
      silo.cell_type      = std::get<0>(GetParam());
      fixture.formulation = std::get<1>(GetParam());
      silo.hopper_height  = std::get<2>(GetParam());
      silo.is_symmetric   = std::get<3>(GetParam());
      silo.wall_height    = 1.7 - silo.hopper_height / 2.;
      silo.element_size   = 0.1;
      if (!silo.is_symmetric)
        silo.outlet_eccentricity = 0.3;
      fixture.start(mesh_silo(silo));

      start_from_rest(fixture);
      run(0.05);
      fixture.stage->contact.take_mean_forces();
    }

    void
    run(const double duration)
    {
      const double end = fixture.stage->clock.time + duration;
      while (fixture.stage->clock.time < end)
        fixture.stage->step();
    }

    ParticleTotals
    totals() const
    {
      return {*fixture.stage, fixture.material.elasticity()};
    }

    StageFixture    fixture;
    SceneParameters silo;
  };



  Tensor<1, dim>
  force_on_material(const WallForce &force)
  {
    return -force.normal_force * force.normal +
           force.tangential_force * wall_tangent(force.normal);
  }
} // namespace



// The forces are recorded as impulses, and step 6 gives the particles just the
// momentum that the nodes get: impulse of the walls and weight make up the
// change of momentum to rounding.
TEST_P(WallBalance, ForcesWeightAndMomentumBalance)
{
  const double         start  = fixture.stage->clock.time;
  const ParticleTotals before = totals();
  run(0.1);
  const ParticleTotals after    = totals();
  const double         duration = fixture.stage->clock.time - start;
  EXPECT_EQ(after.mass_removed, 0.);

  Tensor<1, dim> force;
  for (const WallForce &node : fixture.stage->contact.take_mean_forces())
    force += force_on_material(node);
  // The totals are those of the whole silo.
  const double   factor = fixture.scene->symmetry_factor;
  const double   weight = before.mass() / factor * 9.81;
  Tensor<1, dim> change = after.momentum - before.momentum;
  change[1] /= factor;
  std::cout << "walls' share of the weight " << force[1] / weight
            << ", error of the balance "
            << (force[1] - weight - change[1] / duration) / weight << std::endl;
  EXPECT_GT(std::abs(change[1] / duration / weight), 1e-3)
    << "the balance is not that of a silo at rest";
  EXPECT_NEAR((force[1] - change[1] / duration) / weight, 1., 1e-10);
  // In a ring, hoop stress acts along the radius too.
  if (fixture.formulation == Formulation::plane_strain)
    {
      EXPECT_NEAR((force[0] - change[0] / duration) / weight, 0., 1e-10);
    }
}



TEST_P(WallBalance, TractionsOverTheWallsMakeUpTheForces)
{
  run(0.02);
  const OutputParameters output;
  const WallTractions    observer(output,
                               *fixture.scene,
                               fixture.material,
                               fixture.walls);
  const auto             forces = fixture.stage->contact.take_mean_forces();

  Tensor<1, dim> expected, found;
  double         largest = 0.;
  for (const WallForce &force : forces)
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
                   testing::Values(true)));

INSTANTIATE_TEST_SUITE_P(
  Wholes,
  WallBalance,
  testing::Combine(testing::Values(CellType::triangle, CellType::quadrilateral),
                   testing::Values(Formulation::plane_strain),
                   testing::Values(0., 1.1),
                   testing::Values(false)));
