#include <sandglass/continuum/axisymmetric.h>
#include <sandglass/continuum/plane_strain.h>
#include <sandglass/flow/updated_lagrangian/material_equilibrium.h>
#include <sandglass/flow/updated_lagrangian/newton_solver.h>
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
  /// Root mean squares over the body's volume, relative to those of what they
  /// are errors of.
  struct Errors
  {
    double displacement, gradient, stress;
  };

  /// The static stage's own solver and contact with that body force; only
  /// StaticStage itself, which chooses load steps, has no part in it.
  template <typename Kinematics>
  class SettlementRun
  {
  public:
    SettlementRun(const ElementChoice &element, const unsigned int n_cells)
      : exact{Kinematics::formulation}
      , scene(irregular_square(element.cell_type, n_cells),
              walls,
              Kinematics::formulation,
              4,
              Tensor<1, 2>({0., -9.81}),
              MPI_COMM_WORLD)
      , grid(scene, element.order)
      // The cone is as steep as it can be, so that no stress reaches it.
      , material(exact.elasticity, numbers::PI / 2.)
      , equilibrium(grid,
                    material,
                    exact.density,
                    [this](const Point<2> &point) {
                      return exact.body_force(point);
                    })
      , contact(grid,
                scene,
                walls,
                equilibrium.weight(),
                exact.elasticity.confined_modulus())
      , solver(grid, equilibrium, contact, parameters)
    {}

    Errors
    errors()
    {
      FilledGrid<2>::Vector displacement = grid.make_vector();
      EXPECT_TRUE(
        solver
          .solve(grid.make_vector(),
                 1.,
                 {parameters.maximum_iterations, parameters.maximum_iterations},
                 displacement)
          .has_converged);
      const FieldErrors of(grid, Kinematics::formulation);
      const auto        of_displacement = of.displacement(
        displacement,
        [this](const Point<2> &x) { return exact.displacement(x); },
        [this](const Point<2> &x) { return exact.gradient(x); });
      for (const auto &point : equilibrium.material_points())
        EXPECT_EQ(point.stress, elastic_stress(point));
      return {of_displacement.value,
              of_displacement.gradient,
              of.stress(
                [this](const unsigned int index) {
                  return equilibrium.material_points()[index].stress;
                },
                [this](const Point<2> &x) { return exact.stress(x); })};
    }

  private:
    using MaterialEquilibrium =
      Sandglass::MaterialEquilibrium<Kinematics, DruckerPrager>;

    /// Of the load step, which is the first.
    SymmetricComponents<4>
    elastic_stress(
      const typename MaterialEquilibrium::MaterialPoint &point) const
    {
      return exact.elasticity.stress(
        InPlaneResponse::increment(point.gradient).strain);
    }

    ClearedParameters            cleared;
    WallParameters               walls;
    StaticStageParameters        parameters;
    const ManufacturedSettlement exact;
    Scene<2>                     scene;
    FilledGrid<2>                grid;
    DruckerPrager                material;
    MaterialEquilibrium          equilibrium;
    WallContact<2>               contact;
    NewtonSolver<2>              solver;
  };

  class ManufacturedStatic
    : public testing::TestWithParam<std::tuple<Formulation, ElementChoice>>
  {};
} // namespace



TEST_P(ManufacturedStatic, ConvergesWithTheElementsOrders)
{
  const unsigned int order  = std::get<1>(GetParam()).order;
  const auto         errors = [](const unsigned int n_cells) {
    const auto [formulation, element] = GetParam();
    return formulation == Formulation::plane_strain ?
                     SettlementRun<PlaneStrain>(element, n_cells).errors() :
                     SettlementRun<Axisymmetric>(element, n_cells).errors();
  };
  // On finer meshes quadratic elements' errors fall to what the amplitude adds.
  const unsigned int finest = order == 1 ? 64 : 16;
  Errors             coarse = errors(8);
  for (unsigned int n_cells = 16; n_cells <= finest; n_cells *= 2)
    {
      const Errors fine = errors(n_cells);
      const double displacement_order =
        std::log2(coarse.displacement / fine.displacement);
      const double gradient_order = std::log2(coarse.gradient / fine.gradient);
      const double stress_order   = std::log2(coarse.stress / fine.stress);
      std::cout << n_cells << " cells: displacement error " << fine.displacement
                << ", order " << displacement_order << "; gradient error "
                << fine.gradient << ", order " << gradient_order
                << "; stress error " << fine.stress << ", order "
                << stress_order << std::endl;
      // Orders 2 and 1, or 3 and 2, but for the scatter of irregular meshes.
      EXPECT_GT(displacement_order, order + 0.85);
      EXPECT_GT(gradient_order, order - 0.07);
      EXPECT_GT(stress_order, order - 0.07);
      coarse = fine;
    }
}

INSTANTIATE_TEST_SUITE_P(
  Settings,
  ManufacturedStatic,
  testing::Combine(testing::Values(Formulation::plane_strain,
                                   Formulation::axisymmetric),
                   testing::ValuesIn(all_elements)),
  [](const auto &info) {
    return std::string(std::get<0>(info.param) == Formulation::plane_strain ?
                         "plane_" :
                         "axisymmetric_") +
           name_of(std::get<1>(info.param));
  });
