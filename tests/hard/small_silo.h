#ifndef sandglass_tests_hard_small_silo_h
#define sandglass_tests_hard_small_silo_h

#include <sandglass/scene/make_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "../rest.h"
#include "../stage_fixture.h"

/**
 * A flat-bottomed silo of 32 filled squares or about 80 filled triangles whose
 * outlet opens on the state at rest.
 */
struct SmallSilo
{
  SmallSilo()
  {
    scene.half_width            = 0.2;
    scene.wall_height           = 0.4;
    scene.outlet_half_width     = 0.1;
    scene.fall_region_depth     = 0.2;
    scene.element_size          = 0.05;
    fixture.parameters.end_time = 1e6;
  }

  void
  start(const Sandglass::Mesh<2> &mesh)
  {
    fixture.formulation        = scene.formulation;
    fixture.particles_per_cell = scene.resolution().particles_per_cell;
    fixture.start(mesh);
    start_from_rest(fixture);
    initial_mass = mass_of_all(totals());
  }

  void
  start()
  {
    start(Sandglass::mesh_silo<2>(scene));
  }

  /// Of the grid.
  Sandglass::FlowTotals
  totals() const
  {
    return fixture.stage->view().totals();
  }

  /// @return the largest speed on the way over that of free fall through the
  /// whole grid.
  double
  run_until(const double time)
  {
    const double free_fall =
      std::sqrt(2. * 9.81 * (scene.silo_height() + scene.fall_region_depth));
    double largest = 0.;
    while (fixture.stage->view().clock().time < time)
      {
        fixture.stage->step();
        largest =
          std::max(largest,
                   fixture.stage->view().totals().largest_speed / free_fall);
      }
    return largest;
  }

  /// Relative to the mass at the start.
  double
  mass_error() const
  {
    return mass_of_all(totals()) / initial_mass - 1.;
  }

  double
  discharged_share() const
  {
    return discharged_mass(totals()) / initial_mass;
  }

  /// Let it flow: nothing may be lost, thrown out or not a number.
  void
  expect_sound_flow_until(const double time)
  {
    const double speed = run_until(time);
    std::cout << "discharged " << discharged_share()
              << ", largest speed / free fall " << speed << ", steps "
              << fixture.stage->view().clock().step << std::endl;
    EXPECT_TRUE(fixture.is_finite());
    EXPECT_NEAR(mass_error(), 0., 1e-12);
    EXPECT_EQ(totals().mass_lost, 0.);
    EXPECT_LT(speed, 1.5);
  }

  StageFixture               fixture;
  Sandglass::SceneParameters scene;
  double                     initial_mass = 0.;
};

#endif
