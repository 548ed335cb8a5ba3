#include <sandglass/scene/make_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "rest.h"
#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  constexpr double g = 9.81, outlet_half_width = 0.12; // m, s

  /// A plane silo whose cells grow from a ninth of the outlet at its lip to a
  /// tenth of the silo's half width.
  struct CoarseOutlet : testing::Test
  {
    CoarseOutlet()
    {
      SceneParameters silo;
      silo.half_width                          = 0.9;
      silo.wall_height                         = 3.5;
      silo.outlet_half_width                   = outlet_half_width;
      silo.fall_region_depth                   = 0.5;
      silo.element_size                        = 0.09;
      silo.outlet_element_size                 = 2. * outlet_half_width / 9.;
      fixture.particles_per_cell               = 9;
      fixture.walls.friction_angle             = 18.;
      fixture.material.internal_friction_angle = 31.;
      fixture.material.young_modulus           = 5e6;
      fixture.parameters.end_time              = 1.;
      fixture.start(mesh_silo<2>(silo));
      start_from_rest(fixture);
    }

    /// Of the whole silo, of which half is computed, in kg/m.
    double
    discharged_at(const double time)
    {
      while (fixture.stage->view().clock().time < time)
        fixture.stage->step();
      return 2. * discharged_mass(fixture.stage->view().totals());
    }

    StageFixture fixture;
  };
} // namespace



// The mean rate from 3 to 5 sqrt(D / g). On cells of a ninth to a 48th of the
// outlet, graded or not, with 9 and 16 particles, it is 1.13 to 1.19, with the
// mean at 1.155 (doc/graded-meshes.md). Where loosened particles keep their
// cell's rate of volume it is 0.95 here.
TEST_F(CoarseOutlet, FlowsAsOnFineMeshes)
{
  const double width = 2. * outlet_half_width;
  const double unit  = std::sqrt(width / g);
  const double begin = discharged_at(3. * unit);
  const double rate =
    (discharged_at(5. * unit) - begin) / (2. * unit) /
    (fixture.material.density * std::sqrt(g) * std::pow(width, 1.5));
  std::cout << "rate " << rate << std::endl;
  EXPECT_NEAR(rate / 1.155, 1., 0.07);
}
