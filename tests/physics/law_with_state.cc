// A law with two state variables, added by its file and its name in this
// file's Setting: its variables go with the particles wherever these go, and
// the state at rest and the critical step ask it.

#include <sandglass/continuum/plane_strain.h>
#include <sandglass/flow/particle_in_cell/explicit_particle_stage.h>
#include <sandglass/flow/particle_in_cell/law_adapter.h>
#include <sandglass/flow/updated_lagrangian/material_equilibrium.h>
#include <sandglass/flow/updated_lagrangian/newton_solver.h>
#include <sandglass/flow/updated_lagrangian/wall_contact.h>

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "rectangle_mesh.h"
#include "stage_fixture.h"
#include "void_ratio_law.h"

namespace
{
  using namespace Sandglass;

  using CellSetting =
    Setting<PlaneStrain, CellType::triangle, n_state_numbers<VoidRatioLaw>()>;
  using Stage = ExplicitParticleStage<CellSetting>;

  /// A box in which material falls onto the floor, small particles beside large
  /// ones, so that some are halved.
  Mesh<2>
  graded_box()
  {
    Rectangle rectangle;
    rectangle.n_x = rectangle.n_y = 8;
    rectangle.lower               = Point<2>(0., -0.25);
    rectangle.is_filled = [](const Point<2> &center) { return center[1] > 0.; };
    rectangle.displaced = [](const Point<2> &point) {
      return Point<2>(point[0] * point[0], point[1]);
    };
    return rectangle.mesh();
  }



  class LawWithState : public testing::Test
  {
  protected:
    LawWithState()
    {
      fixture.parameters.end_time          = 1e3;
      fixture.parameters.volumetric_strain = VolumetricStrain::element;
      fixture.parameters.force_integration = ForceIntegration::particles;
      mesh                                 = graded_box();
    }

    std::unique_ptr<Stage>
    make_stage()
    {
      fixture.parameters.check();
      scene = std::make_unique<Scene<2>>(mesh,
                                         fixture.walls,
                                         Formulation::plane_strain,
                                         4,
                                         fixture.gravity,
                                         MPI_COMM_WORLD);
      return make_stage_on_scene();
    }

    std::unique_ptr<Stage>
    make_stage_on_scene()
    {
      const auto make = [this](const auto &geometry) {
        return make_law<CellSetting, VoidRatioLaw>(fixture.material,
                                                   fixture.parameters,
                                                   geometry);
      };
      return std::make_unique<Stage>(*scene,
                                     make,
                                     fixture.material.density,
                                     fixture.walls,
                                     fixture.parameters,
                                     fixture.feed);
    }

    StageFixture              fixture; // for its parameters
    Mesh<2>                   mesh;
    std::unique_ptr<Scene<2>> scene;
  };
} // namespace



TEST_F(LawWithState, variables_go_with_the_particles)
{
  const auto         stage      = make_stage();
  const Flow        &flow       = *stage;
  const unsigned int n_at_first = flow.view().totals().n_particles;
  for (unsigned int n = 0; n < 300; ++n)
    stage->step();

  double       largest_error = 0., largest_change = 0.;
  unsigned int n_halves = 0;
  flow.view().for_each_particle([&](const ParticleRecord &particle) {
    const double void_ratio = particle.law_state[0];
    const double trace =
      particle.law_state[1] + particle.law_state[2] + particle.law_state[3];
    const double expansion =
      (1. + void_ratio) / (1. + VoidRatioLaw::initial_void_ratio);
    largest_change = std::max(largest_change, std::abs(expansion - 1.));
    // Both follow the volume, to first and second order in a step's strain.
    largest_error =
      std::max(largest_error,
               std::abs(
                 expansion * particle.density / fixture.material.density - 1.));
    EXPECT_NEAR(trace, std::log(expansion), 0.02);
    n_halves += particle.id >= n_at_first;
  });
  std::cout << "largest expansion " << largest_change << ", error "
            << largest_error << ", halves " << n_halves << std::endl;
  EXPECT_GT(largest_change, 0.1) << "separated particles";
  EXPECT_LT(largest_error, 0.02 * largest_change);
  EXPECT_GT(n_halves, 0u);
}



TEST_F(LawWithState, variables_are_in_checkpoints)
{
  auto stage = make_stage();
  for (unsigned int n = 0; n < 50; ++n)
    stage->step();
  std::stringstream state;
  {
    boost::archive::binary_oarchive archive(state);
    stage->save(archive);
  }
  auto resumed = make_stage_on_scene();
  {
    boost::archive::binary_iarchive archive(state);
    resumed->load(archive);
  }
  for (unsigned int n = 0; n < 20; ++n)
    {
      stage->step();
      resumed->step();
    }

  const auto numbers = [](const Flow &flow) {
    std::vector<double> result;
    flow.view().for_each_particle([&](const ParticleRecord &particle) {
      result.push_back(particle.id);
      result.push_back(particle.velocity[1]);
      for (unsigned int i = 0; i < 5; ++i)
        result.push_back(particle.law_state[i]);
    });
    return result;
  };
  EXPECT_EQ(numbers(*stage), numbers(*resumed));
}



TEST_F(LawWithState, critical_step_follows_the_stiffness)
{
  const auto   stage   = make_stage();
  const Flow  &flow    = *stage;
  const double at_zero = flow.view().critical_time_step(true);
  // A pressure that makes the material four times as stiff.
  stage->start_from(
    [](const unsigned int, const Point<2> &) {
      return InitialState<2>{
        {}, isotropic<4>(-3. * VoidRatioLaw::doubling_pressure), 1.};
    },
    {});
  EXPECT_NEAR(flow.view().critical_time_step(true),
              at_zero / 2.,
              0.01 * at_zero);
}



TEST_F(LawWithState, rest_asks_the_law)
{
  // A column at rest between smooth walls.
  Rectangle rectangle;
  rectangle.n_x  = 2;
  rectangle.n_y  = 8;
  rectangle.left = rectangle.right = BoundaryRole::axis;
  mesh                             = rectangle.mesh();
  scene                            = std::make_unique<Scene<2>>(mesh,
                                     fixture.walls,
                                     Formulation::plane_strain,
                                     4,
                                     fixture.gravity,
                                     MPI_COMM_WORLD);
  const FilledGrid<2>                            grid(*scene);
  MaterialEquilibrium<PlaneStrain, VoidRatioLaw> equilibrium(
    grid,
    VoidRatioLaw(fixture.material),
    fixture.material.density,
    fixture.gravity);
  WallContact<2>              contact(grid,
                         *scene,
                         fixture.walls,
                         equilibrium.weight(),
                         equilibrium.confined_modulus());
  const StaticStageParameters parameters;
  NewtonSolver<2>             solver(grid, equilibrium, contact, parameters);

  DisplacementVector displacement = grid.make_vector();
  unsigned int       n_iterations = 0;
  for (const double load : {0.25, 0.5, 0.75, 1.})
    {
      DisplacementVector increment = grid.make_vector();
      const NewtonResult result    = solver.solve(displacement,
                                               load,
                                               {parameters.maximum_iterations,
                                                   parameters.maximum_iterations},
                                               increment);
      ASSERT_TRUE(result.has_converged) << "load " << load;
      n_iterations += result.n_iterations;
      displacement.zero_out_ghost_values();
      displacement.add(1., increment);
      displacement.update_ghost_values();
      equilibrium.start_step();
      contact.commit();
    }
  EXPECT_LE(n_iterations, 24u) << "the tangent is the law's";

  for (const auto &local_cell : grid.local_cells)
    {
      const auto point =
        equilibrium.point_state(grid.point_index(*local_cell.cell, 0));
      // To first and to second order in a load step's strain.
      EXPECT_NEAR((1. + point.law_state[0]) /
                    (1. + VoidRatioLaw::initial_void_ratio),
                  point.volume_ratio,
                  0.01 * (1. - point.volume_ratio));
      EXPECT_LT(point.volume_ratio, 1.);
    }
}
