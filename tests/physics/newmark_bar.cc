#include <sandglass/continuum/plane_strain.h>
#include <sandglass/flow/updated_lagrangian/material_equilibrium.h>
#include <sandglass/flow/updated_lagrangian/newmark_motion.h>
#include <sandglass/flow/updated_lagrangian/wall_contact.h>
#include <sandglass/material/drucker_prager.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "../element_choice.h"
#include "../rectangle_mesh.h"
#include "cleared_parameters.h"

using namespace Sandglass;

namespace
{
  constexpr double pi = numbers::PI;

  /// So cohesive that it stays elastic in tension too.
  MaterialConstants
  elastic_material()
  {
    MaterialConstants constants;
    constants.cohesion = 1e9;
    return constants;
  }

  /**
   * An elastic bar of length 1 between smooth side walls, held at its lower
   * end, that swings along its length without weight in its slowest mode,
   * sin(pi y / 2). Its amplitude is so small that it is linear to a millionth.
   */
  class SwingingBar
  {
  public:
    /// @param time_step  over the exact period.
    SwingingBar(const ElementChoice     &element,
                const double             time_step,
                const NewmarkParameters &newmark = {})
      : scene(mesh(element.cell_type),
              walls,
              Formulation::plane_strain,
              4,
              Tensor<1, 2>(),
              MPI_COMM_WORLD)
      , grid(scene, element.order)
      , equilibrium(grid,
                    DruckerPrager(elastic_material()),
                    density,
                    Tensor<1, 2>())
      , mass(grid,
             Formulation::plane_strain,
             [](const Point<2> &) { return density; })
      , contact(grid, scene, walls, equilibrium.weight(), 1e6)
      , motion(grid,
               equilibrium,
               mass,
               contact,
               {time_step * period(), newmark},
               solver_parameters)
    {
      mode                      = nodal_field(grid, [](const Point<2> &x) {
        return Tensor<1, 2>({0., amplitude * std::sin(pi * x[1] / 2.)});
      });
      DisplacementVector forces = grid.make_vector();
      equilibrium.evaluate_forces(mode, 0., forces);
      equilibrium.start_step();
      motion.start(mode, grid.make_vector());
    }

    static double
    period()
    {
      return 4. / Elasticity(1e6, 0.3).wave_speed(density);
    }

    /// How far the bar is in its mode; 1 at the start.
    double
    deflection() const
    {
      return (mode * motion.displacement()) / (mode * mode);
    }

    double
    energy() const
    {
      const auto energies = motion.energies();
      EXPECT_EQ(energies.dissipated, 0.);
      return energies.kinetic + energies.elastic;
    }

    /// Four times the time to the middle, over the exact period. In between the
    /// steps the motion is taken as a cosine, as the method's solution is.
    double
    measured_period()
    {
      double before = deflection();
      while (deflection() > 0.)
        {
          before = deflection();
          motion.step();
        }
      const double angle_before = std::acos(before);
      const double angle_after  = std::acos(deflection());
      const double share_after =
        (angle_after - pi / 2.) / (angle_after - angle_before);
      return 4. * (motion.time() - share_after * motion.last_time_step()) /
             period();
    }

    static Mesh<2>
    mesh(const CellType cell_type)
    {
      Rectangle rectangle;
      rectangle.cell_type = cell_type;
      rectangle.upper     = Point<2>(1. / 8., 1.);
      rectangle.n_x       = 1;
      rectangle.n_y       = 16;
      rectangle.left = rectangle.right = BoundaryRole::axis;
      rectangle.bottom                 = BoundaryRole::axis;
      return rectangle.mesh();
    }

    static constexpr double density = 1500., amplitude = 1e-7;

    ClearedParameters                               cleared;
    WallParameters                                  walls;
    StaticStageParameters                           solver_parameters;
    Scene<2>                                        scene;
    FilledGrid<2>                                   grid;
    MaterialEquilibrium<PlaneStrain, DruckerPrager> equilibrium;
    ConsistentMass<2>                               mass;
    WallContact<2>                                  contact;
    NewmarkMotion<2>                                motion;
    DisplacementVector                              mode;
  };

  class NewmarkBar : public testing::TestWithParam<ElementChoice>
  {};
} // namespace



// With delta = 1/2 and alpha = 1/4 the method's period of a mode of angular
// frequency omega is pi dt / arctan(omega dt / 2), too long by the share (omega
// dt)^2 / 12.
TEST_P(NewmarkBar, PeriodHasTheMethodsError)
{
  for (const unsigned int n_steps : {20, 40, 80})
    {
      SwingingBar  bar(GetParam(), 1. / n_steps);
      const double period   = bar.measured_period();
      const double expected = pi / n_steps / std::atan(pi / n_steps);
      std::cout << n_steps << " steps: period " << period << ", expected "
                << expected << std::endl;
      // Linear elements with their consistent mass swing too fast, by the share
      // (pi h / 2)^2 / 24 = 4e-4.
      EXPECT_NEAR(period, expected, GetParam().order == 2 ? 1e-5 : 1e-3);
    }
}



TEST_P(NewmarkBar, EnergyIsKept)
{
  SwingingBar  bar(GetParam(), 0.07);
  const double start = bar.energy();
  for (unsigned int i = 0; i < 100; ++i)
    {
      bar.motion.step();
      EXPECT_NEAR(bar.energy() / start, 1., 1e-6);
    }
  EXPECT_GT(bar.motion.energies().kinetic, 0.01 * start);
}



TEST_P(NewmarkBar, LargerDeltaDamps)
{
  SwingingBar  bar(GetParam(), 0.07, {0.6, 0.3025});
  const double start = bar.energy();
  for (unsigned int i = 0; i < 100; ++i)
    bar.motion.step();
  EXPECT_LT(bar.energy(), 0.2 * start);
}

INSTANTIATE_TEST_SUITE_P(Elements,
                         NewmarkBar,
                         testing::ValuesIn(all_elements),
                         element_name);
