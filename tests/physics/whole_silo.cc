#include <sandglass/scene/make_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "mirrored_mesh.h"
#include "rest.h"
#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  /// A plane silo whose outlet opens on the state at rest.
  struct Silo
  {
    Silo()
    {
      parameters.element_size = 0.1;
    }

    void
    start(const Mesh<2> &mesh)
    {
      fixture.parameters.end_time = 2.5;
      fixture.start(mesh);
      forces = start_from_rest(fixture).wall_forces;
    }

    /// Of the grid.
    FlowTotals
    totals() const
    {
      return fixture.stage->view().totals();
    }

    void
    run_until(const double time)
    {
      while (fixture.stage->view().clock().time < time * (1. - 1e-12))
        fixture.stage->step();
    }

    StageFixture              fixture;
    SceneParameters           parameters;
    std::vector<WallForce<2>> forces;
  };



  class WholeSilo : public testing::TestWithParam<std::tuple<CellType, double>>
  {
  protected:
    void
    choose_shape(Silo &silo) const
    {
      silo.parameters.cell_type     = std::get<0>(GetParam());
      silo.parameters.hopper_height = std::get<1>(GetParam());
      silo.parameters.wall_height   = 1.7 - std::get<1>(GetParam()) / 2.;
    }
  };
} // namespace



// Static equilibrium is found to a relative residual of 1e-10 or better, so
// both halves of the mirrored mesh must carry what the half does.
TEST_P(WholeSilo, AtRestBothSidesCarryWhatTheHalfDoes)
{
  Silo half;
  choose_shape(half);
  const Mesh<2> mesh = mesh_silo<2>(half.parameters);
  half.start(mesh);
  Silo whole;
  whole.start(mirrored(mesh));

  double largest = 0.;
  for (const auto &force : half.forces)
    largest = std::max(largest, std::abs(force.normal_force()));
  unsigned int n_compared = 0;
  for (const auto &expected : half.forces)
    for (const auto &found : whole.forces)
      {
        const Point<2> here = whole.fixture.scene->mesh.vertices[found.vertex];
        const Point<2> there =
          half.fixture.scene->mesh.vertices[expected.vertex];
        const Point<2> image(-here[0], here[1]);
        const bool     is_same  = here.distance(there) < 1e-9;
        const bool     is_image = image.distance(there) < 1e-9;
        // Forces on the axis are those of half a node, in the half.
        if (found.wall != expected.wall || (!is_same && !is_image) ||
            (is_same && is_image))
          continue;
        ++n_compared;
        EXPECT_NEAR(found.normal_force() / largest,
                    expected.normal_force() / largest,
                    1e-6);
        const double sign = is_image ? -1. : 1.;
        EXPECT_NEAR(sign * found.force[0] / largest,
                    expected.force[0] / largest,
                    1e-6);
        EXPECT_NEAR(found.force[1] / largest,
                    expected.force[1] / largest,
                    1e-6);
      }
  EXPECT_EQ(n_compared, 2 * (half.forces.size() - 1));
}



// On the mirrored mesh only rounding tells the two sides apart, and that has
// hardly grown after 0.2 s.
TEST_P(WholeSilo, TheMirroredMeshFlowsLikeTheHalf)
{
  Silo half;
  choose_shape(half);
  half.fixture.parameters.time_step_text = "2e-4";
  const Mesh<2> mesh                     = mesh_silo<2>(half.parameters);
  half.start(mesh);
  half.run_until(0.2);
  Silo whole;
  whole.fixture.parameters.time_step_text = "2e-4";
  whole.start(mirrored(mesh));
  whole.run_until(0.2);

  const FlowTotals expected = half.totals(), found = whole.totals();
  std::cout << "kinetic energy " << found.kinetic_energy << " J, of the half "
            << 2. * expected.kinetic_energy << " J; momentum " << found.momentum
            << std::endl;
  EXPECT_EQ(half.fixture.scene->symmetry_factor, 2.);
  EXPECT_EQ(whole.fixture.scene->symmetry_factor, 1.);
  EXPECT_EQ(found.n_particles, 2 * expected.n_particles);
  EXPECT_NEAR(discharged_mass(found) / (2. * discharged_mass(expected)),
              1.,
              1e-6);
  EXPECT_NEAR(found.kinetic_energy / (2. * expected.kinetic_energy), 1., 1e-6);
  EXPECT_NEAR(found.elastic_energy / (2. * expected.elastic_energy), 1., 1e-6);
  EXPECT_NEAR(found.momentum[0] / found.momentum[1], 0., 1e-6);
}



// The outlet is a whole number of elements wide, so that the lips' nodes are
// equally far apart in both. Other meshes of the half (seeds, algorithms)
// differ by some per cent too.
TEST_P(WholeSilo, TheFreeMeshFlowsLikeTheHalf)
{
  const auto rate = [this](const bool is_symmetric) {
    Silo silo;
    choose_shape(silo);
    silo.parameters.is_symmetric      = is_symmetric;
    silo.parameters.outlet_half_width = 0.2;
    silo.parameters.element_size      = 0.05;
    silo.start(mesh_silo<2>(silo.parameters));
    silo.run_until(0.4);
    const double factor = silo.fixture.scene->symmetry_factor;
    const double before = discharged_mass(silo.totals());
    const double start  = silo.fixture.stage->view().clock().time;
    silo.run_until(1.);
    EXPECT_EQ(silo.totals().mass_lost, 0.);
    return factor * (discharged_mass(silo.totals()) - before) /
           (silo.fixture.stage->view().clock().time - start);
  };
  const double half = rate(true), whole = rate(false);
  std::cout << "flow rate in kg/(s m): half " << half << ", whole " << whole
            << std::endl;
  EXPECT_NEAR(whole / half, 1., 0.05);
}



TEST_P(WholeSilo, AnEccentricOneEmptiesWithoutLoss)
{
  Silo silo;
  choose_shape(silo);
  silo.parameters.is_symmetric        = false;
  silo.parameters.outlet_eccentricity = 0.3;
  silo.parameters.check();
  silo.start(mesh_silo<2>(silo.parameters));
  const double mass = mass_of_all(silo.totals());
  silo.run_until(2.5);
  const FlowTotals end = silo.totals();
  std::cout << "discharged " << discharged_mass(end) << " of " << mass
            << " kg/m" << std::endl;
  EXPECT_EQ(end.mass_lost, 0.);
  EXPECT_NEAR(mass_of_all(end) / mass, 1., 1e-12);
  EXPECT_GT(discharged_mass(end), 0.4 * mass);
}



INSTANTIATE_TEST_SUITE_P(
  Shapes,
  WholeSilo,
  testing::Combine(testing::Values(CellType::triangle, CellType::quadrilateral),
                   testing::Values(0., 1.1)));
