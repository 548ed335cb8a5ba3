#include <sandglass/scene/make_mesh.h>

#include <gtest/gtest.h>

#include <iostream>

#include "rest.h"
#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  class ClosedHopper
    : public testing::TestWithParam<std::tuple<Formulation, CellType, double>>
  {};
} // namespace



// Between wall and hopper the weight pushes a node along both, and the force
// that holds it lies outside the walls' normals but inside their friction
// cones: it stays, and nothing is driven round the corner. The fixture watches
// that dissipated energy never comes back.
TEST_P(ClosedHopper, SettlesAndStaysAtRest)
{
  StageFixture    fixture;
  SceneParameters scene;
  const auto [formulation, cell_type, height] = GetParam();
  scene.element_size                          = 0.1;
  scene.hopper_height                         = height;
  scene.cell_type                             = cell_type;
  scene.formulation                           = formulation;
  scene.outlet_is_open                        = false;
  fixture.formulation                         = formulation;
  fixture.parameters.end_time                 = 3.;
  fixture.start(mesh_silo<2>(scene));
  start_from_rest(fixture);

  const Settling settling = fixture.stage->settle();
  std::cout << "settled in " << settling.n_steps << " steps, then "
            << settling.largest_speed << " m/s" << std::endl;
  EXPECT_EQ(fixture.stage->view().clock().step, 0u);
  EXPECT_EQ(fixture.stage->view().clock().time, 0.);
  EXPECT_EQ(fixture.stage->dissipation(), 0.);

  const double energy = fixture.stage->view().totals().elastic_energy;
  while (!fixture.stage->is_finished())
    fixture.stage->step();
  const FlowTotals totals = fixture.stage->view().totals();
  std::cout << "after 3 s " << totals.largest_speed << " m/s, dissipated "
            << totals.dissipated_energy << " J" << std::endl;
  EXPECT_LT(totals.largest_speed, 1e-3);
  EXPECT_LT(totals.dissipated_energy, 1e-3 * energy);
}

INSTANTIATE_TEST_SUITE_P(
  Silos,
  ClosedHopper,
  testing::Combine(testing::Values(Formulation::plane_strain,
                                   Formulation::axisymmetric),
                   testing::Values(CellType::triangle, CellType::quadrilateral),
                   testing::Values(0.1, 1., 3.)));
