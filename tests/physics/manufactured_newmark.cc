#include <sandglass/continuum/axisymmetric.h>
#include <sandglass/continuum/plane_strain.h>
#include <sandglass/flow/updated_lagrangian/material_equilibrium.h>
#include <sandglass/flow/updated_lagrangian/newmark_motion.h>
#include <sandglass/flow/updated_lagrangian/wall_contact.h>
#include <sandglass/material/drucker_prager.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "../element_choice.h"
#include "../field_errors.h"
#include "../irregular_square.h"
#include "../manufactured_settlement.h"
#include "cleared_parameters.h"

using namespace Sandglass;

namespace
{
  struct Errors
  {
    double displacement, velocity, stress;
  };

  /**
   * The settlement's displacement times sin(omega t), up to omega t = 2, where
   * it has turned round. While the sine is positive all material is
   * compressed. The body force that it needs, without inertia that of the
   * settlement at rest, grows with the sine as well.
   */
  template <typename Kinematics>
  class MotionRun
  {
  public:
    MotionRun(const ElementChoice &element, const unsigned int n_cells)
      : exact{Kinematics::formulation}
      , scene(irregular_square(element.cell_type, n_cells),
              walls,
              Kinematics::formulation,
              4,
              Tensor<1, 2>({0., -9.81}),
              MPI_COMM_WORLD)
      , grid(scene, element.order)
      // The cone is as steep as it can be, so that no stress reaches it.
      , equilibrium(grid,
                    DruckerPrager(exact.elasticity, numbers::PI / 2.),
                    exact.density,
                    [this](const Point<2> &x) {
                      return exact.body_force(x) -
                             omega * omega * exact.displacement(x);
                    })
      , mass(grid,
             Kinematics::formulation,
             [this](const Point<2> &) { return exact.density; })
      , contact(grid,
                scene,
                walls,
                equilibrium.weight(),
                exact.elasticity.confined_modulus())
      // What the step adds falls as the elements' error in displacement does.
      , n_steps(static_cast<unsigned int>(
          std::ceil(4. * std::pow(n_cells, (element.order + 1) / 2.))))
      , motion(grid,
               equilibrium,
               mass,
               contact,
               {end / n_steps, {}},
               solver_parameters)
    {}

    Errors
    errors()
    {
      motion.set_load_history(
        [](const double time) { return std::sin(omega * time); });
      motion.start(grid.make_vector(),
                   nodal_field(grid, [this](const Point<2> &x) {
                     return omega * exact.displacement(x);
                   }));
      for (unsigned int i = 0; i < n_steps; ++i)
        motion.step();
      EXPECT_NEAR(motion.time(), end, 1e-12 * end);

      const FieldErrors of(grid, Kinematics::formulation);
      const auto        displacement_times = [this](const double factor) {
        return [this, factor](const Point<2> &x) {
          return factor * exact.displacement(x);
        };
      };
      const auto gradient_times = [this](const double factor) {
        return [this, factor](const Point<2> &x) {
          return factor * exact.gradient(x);
        };
      };
      const double sine = std::sin(omega * end);
      const double rate = omega * std::cos(omega * end);
      return {of.displacement(motion.displacement(),
                              displacement_times(sine),
                              gradient_times(sine))
                .value,
              of.displacement(motion.velocity(),
                              displacement_times(rate),
                              gradient_times(rate))
                .value,
              of.stress(
                [this](const unsigned int index) {
                  return equilibrium.material_points()[index].stress;
                },
                [&](const Point<2> &x) {
                  return SymmetricComponents<4>(sine * exact.stress(x));
                })};
    }

  private:
    /// Twice as fast as a wave crosses the body, so that inertia matters.
    static constexpr double omega = 60.;        // 1/s
    static constexpr double end   = 2. / omega; // s

    ClearedParameters                              cleared;
    WallParameters                                 walls;
    StaticStageParameters                          solver_parameters;
    const ManufacturedSettlement                   exact;
    Scene<2>                                       scene;
    FilledGrid<2>                                  grid;
    MaterialEquilibrium<Kinematics, DruckerPrager> equilibrium;
    ConsistentMass<2>                              mass;
    WallContact<2>                                 contact;
    const unsigned int                             n_steps;
    NewmarkMotion<2>                               motion;
  };

  class ManufacturedNewmark
    : public testing::TestWithParam<std::tuple<Formulation, ElementChoice>>
  {};
} // namespace



TEST_P(ManufacturedNewmark, ConvergesWithTheElementsOrders)
{
  const unsigned int order  = std::get<1>(GetParam()).order;
  const auto         errors = [](const unsigned int n_cells) {
    const auto [formulation, element] = GetParam();
    return formulation == Formulation::plane_strain ?
                     MotionRun<PlaneStrain>(element, n_cells).errors() :
                     MotionRun<Axisymmetric>(element, n_cells).errors();
  };
  const unsigned int finest = order == 1 ? 32 : 16;
  Errors             coarse = errors(8);
  for (unsigned int n_cells = 16; n_cells <= finest; n_cells *= 2)
    {
      const Errors fine = errors(n_cells);
      const double displacement_order =
        std::log2(coarse.displacement / fine.displacement);
      const double velocity_order = std::log2(coarse.velocity / fine.velocity);
      const double stress_order   = std::log2(coarse.stress / fine.stress);
      std::cout << n_cells << " cells: displacement error " << fine.displacement
                << ", order " << displacement_order << "; velocity error "
                << fine.velocity << ", order " << velocity_order
                << "; stress error " << fine.stress << ", order "
                << stress_order << std::endl;
      // Orders 2 and 1, or 3 and 2, but for the scatter of irregular meshes.
      EXPECT_GT(displacement_order, order + 0.8);
      EXPECT_GT(stress_order, order - 0.1);
      EXPECT_GT(velocity_order, order + 0.8);
      coarse = fine;
    }
}

INSTANTIATE_TEST_SUITE_P(
  Settings,
  ManufacturedNewmark,
  testing::Combine(testing::Values(Formulation::plane_strain,
                                   Formulation::axisymmetric),
                   testing::ValuesIn(all_elements)),
  [](const auto &info) {
    return std::string(std::get<0>(info.param) == Formulation::plane_strain ?
                         "plane_" :
                         "axisymmetric_") +
           name_of(std::get<1>(info.param));
  });
