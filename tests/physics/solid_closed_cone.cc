#include <sandglass/flow/updated_lagrangian/static_stage.h>
#include <sandglass/run/static_to_particles.h>
#include <sandglass/scene/make_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "solid_fixture.h"

using namespace Sandglass;

namespace
{
  class SolidClosedCone : public testing::TestWithParam<CellType>
  {
  protected:
    /// A quarter of a round silo with a hopper, between two symmetry planes:
    /// its few facets make the wall's normals lean out of the planes.
    static Mesh<3>
    mesh()
    {
      SceneParameters silo;
      silo.formulation       = Formulation::three_dimensions;
      silo.cell_type         = GetParam();
      silo.cross_section     = SceneParameters::CrossSection::circle;
      silo.outlet_shape      = SceneParameters::OutletShape::circle;
      silo.half_width        = 0.5;
      silo.wall_height       = 0.4;
      silo.hopper_height     = 0.6;
      silo.outlet_half_width = 0.125;
      silo.fall_region_depth = 0.2;
      silo.element_size      = 0.125;
      silo.gravity           = {0., -9.81, 0.};
      silo.outlet_is_open    = false;
      return make_mesh<3>(silo, MPI_COMM_SELF);
    }

    double
    largest_speed() const
    {
      double largest = 0.;
      fixture.stage->view().for_each_particle(
        [&largest](const ParticleRecord &particle) {
          largest = std::max(largest, particle.velocity.norm());
        });
      return largest;
    }

    SolidFixture fixture;
  };
} // namespace

INSTANTIATE_TEST_SUITE_P(CellTypes,
                         SolidClosedCone,
                         testing::Values(CellType::hexahedron,
                                         CellType::tetrahedron));

// What is at rest in it stays so: friction beside the symmetry planes, which
// the state at rest has left, pushes nothing off them.
TEST_P(SolidClosedCone, StaysAtRest)
{
  fixture.walls.friction_angle = 20.;
  fixture.start(mesh());
  StaticStage<3> static_stage(*fixture.scene,
                              fixture.material,
                              fixture.walls,
                              fixture.static_stage,
                              fixture.no_log);
  carry_to_particles(static_stage.run(), *fixture.scene, *fixture.stage, true);
  while (fixture.stage->view().clock().time < 0.3)
    fixture.stage->step();
  std::cout << "largest speed " << largest_speed() << " m/s" << std::endl;
  EXPECT_LT(largest_speed(), 0.05);
}
