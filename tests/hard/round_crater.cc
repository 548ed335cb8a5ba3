#include <sandglass/scene/make_mesh.h>

#include <gtest/gtest.h>

#include <iostream>

#include "../solid_fixture.h"

using namespace Sandglass;

namespace
{
  /// A quarter of a round silo with a flat bottom, 1 m wide and 1.2 m high, in
  /// hexahedra that are twenty times smaller above the outlet than at the wall.
  struct RoundSilo
  {
    RoundSilo()
    {
      scene.formulation       = Formulation::three_dimensions;
      scene.cell_type         = CellType::hexahedron;
      scene.cross_section     = SceneParameters::CrossSection::circle;
      scene.outlet_shape      = SceneParameters::OutletShape::circle;
      scene.half_width        = 0.5;
      scene.wall_height       = 1.2;
      scene.outlet_half_width = 0.125;
      scene.fall_region_depth = 0.25;
      scene.refinement        = 0.6;

      fixture.material.internal_friction_angle = 30.;
      fixture.parameters.end_time              = 1e6;
      fixture.particles_per_cell = scene.resolution().particles_per_cell;
      fixture.start(mesh_silo<3>(scene));
      initial_mass = fixture.stage->view().totals().mass_in_silo;
    }

    /// In kg.
    double
    discharged_until(const double time)
    {
      while (fixture.stage->view().clock().time < time)
        fixture.stage->step();
      return initial_mass - fixture.stage->view().totals().mass_in_silo;
    }

    SolidFixture    fixture;
    SceneParameters scene;
    double          initial_mass = 0.; ///< in kg
  };
} // namespace



// A crater's slope sends loose material down to the middle. There it must not
// gather, which would let more and more through the outlet (without relief 1.2
// times as much), and no particle may be thrown out. The rate of flow without a
// head is steady.
TEST(RoundCrater, FlowsSteadily)
{
  RoundSilo    silo;
  const double first  = silo.discharged_until(0.7);
  const double second = silo.discharged_until(1.7) - first;
  const double third  = silo.discharged_until(3.);
  const double fourth = silo.discharged_until(4.) - third;
  std::cout << "rates of a quarter from 0.7 and from 3 s: " << second << ", "
            << fourth << " kg/s" << std::endl;
  EXPECT_NEAR(fourth / second, 1., 0.1);
  EXPECT_EQ(silo.fixture.stage->view().totals().mass_lost, 0.);
}
