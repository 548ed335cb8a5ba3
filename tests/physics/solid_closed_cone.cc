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

// Material that settles in it comes to rest: friction beside the symmetry
// planes pushes nothing off them.
TEST_P(SolidClosedCone, ComesToRest)
{
  fixture.walls.friction_angle = 20.;
  fixture.start(mesh());
  const double early = 0.1, late = 0.5;
  while (fixture.stage->view().clock().time < early)
    fixture.stage->step();
  const double speed = largest_speed();
  while (fixture.stage->view().clock().time < late)
    fixture.stage->step();
  std::cout << "largest speed " << speed << " m/s at " << early << " s, "
            << largest_speed() << " m/s at " << late << " s" << std::endl;
  EXPECT_LT(largest_speed(), std::max(0.1, speed));
}
