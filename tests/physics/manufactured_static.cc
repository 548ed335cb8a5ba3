#include <deal.II/base/quadrature_lib.h>

#include <sandglass/choices.h>
#include <sandglass/flow/updated_lagrangian/material_equilibrium.h>
#include <sandglass/flow/updated_lagrangian/newton_solver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "../manufactured_settlement.h"
#include "../random_engine.h"
#include "../rectangle_mesh.h"

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
    SettlementRun(const CellType cell_type, const unsigned int n_cells)
      : exact{Kinematics::formulation}
      , scene(mesh(cell_type, n_cells),
              walls,
              Kinematics::formulation,
              4,
              Tensor<1, 2>({0., -9.81}),
              MPI_COMM_WORLD)
      , grid(scene)
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
      Errors result{};
      add_displacement_errors(displacement, result);
      result.stress = stress_error();
      return result;
    }

  private:
    /// Regular meshes are kinder to stresses than those in use: each inner
    /// vertex is moved by up to a fifth of a cell in both directions.
    static Mesh<2>
    mesh(const CellType cell_type, const unsigned int n_cells)
    {
      auto                                   engine = random_engine();
      std::uniform_real_distribution<double> share(-0.2, 0.2);
      Rectangle                              rectangle;
      rectangle.cell_type = cell_type;
      rectangle.n_x = rectangle.n_y = n_cells;
      rectangle.left = rectangle.right = BoundaryRole::axis;
      rectangle.bottom                 = BoundaryRole::axis;
      rectangle.displaced              = [&](const Point<2> &regular) {
        const double x = share(engine), y = share(engine);
        return regular + Tensor<1, 2>({x / n_cells, y / n_cells});
      };
      return rectangle.mesh();
    }

    double
    volume(const FEValues<2> &fe_values, const unsigned int q) const
    {
      return fe_values.JxW(q) *
             (scene.formulation == Formulation::axisymmetric ?
                fe_values.quadrature_point(q)[0] :
                1.);
    }

    /// The quadrature here is exact enough to add no error of its own.
    void
    add_displacement_errors(const FilledGrid<2>::Vector &displacement,
                            Errors                      &result) const
    {
      const Quadrature<2> quadrature =
        scene.mesh.cell_type == CellType::triangle ?
          Quadrature<2>(QGaussSimplex<2>(4)) :
          Quadrature<2>(QGauss<2>(4));
      FEValues<2>                          fe_values(grid.mapping,
                            grid.finite_element,
                            quadrature,
                            update_values | update_gradients |
                              update_quadrature_points | update_JxW_values);
      std::vector<types::global_dof_index> dofs(
        grid.finite_element.n_dofs_per_cell());
      double displacement_scale = 0., gradient_scale = 0.;
      for (const auto &cell : grid.dof_handler.active_cell_iterators())
        {
          fe_values.reinit(cell);
          cell->get_dof_indices(dofs);
          for (const unsigned int q : fe_values.quadrature_point_indices())
            {
              const Point<2>     point = fe_values.quadrature_point(q);
              const Tensor<1, 2> u     = exact.displacement(point);
              const Tensor<2, 2> H     = exact.gradient(point);
              Tensor<1, 2>       u_error(-u);
              Tensor<2, 2>       H_error(-H);
              for (const unsigned int i : fe_values.dof_indices())
                {
                  const unsigned int c     = grid.component(i);
                  const double       value = displacement[dofs[i]];
                  u_error[c] += value * fe_values.shape_value(i, q);
                  H_error[c] += value * fe_values.shape_grad(i, q);
                }
              result.displacement +=
                u_error.norm_square() * volume(fe_values, q);
              result.gradient += H_error.norm_square() * volume(fe_values, q);
              displacement_scale += u.norm_square() * volume(fe_values, q);
              gradient_scale += H.norm_square() * volume(fe_values, q);
            }
        }
      result.displacement = std::sqrt(result.displacement / displacement_scale);
      result.gradient     = std::sqrt(result.gradient / gradient_scale);
    }

    /// Error of the stress at the stage's own quadrature points.
    double
    stress_error() const
    {
      FEValues<2> fe_values(grid.mapping,
                            grid.finite_element,
                            grid.quadrature,
                            update_quadrature_points | update_JxW_values);
      double      error = 0., scale = 0.;
      for (const auto &cell : grid.dof_handler.active_cell_iterators())
        {
          fe_values.reinit(cell);
          for (const unsigned int q : fe_values.quadrature_point_indices())
            {
              const auto &point =
                equilibrium.material_points()[grid.point_index(*cell, q)];
              EXPECT_EQ(point.stress, elastic_stress(point));
              const SymmetricComponents<4> stress =
                exact.stress(fe_values.quadrature_point(q));
              const SymmetricComponents<4> difference = point.stress - stress;
              error += double_contraction(difference, difference) *
                       volume(fe_values, q);
              scale +=
                double_contraction(stress, stress) * volume(fe_values, q);
            }
        }
      return std::sqrt(error / scale);
    }

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

    struct ClearedParameters
    {
      ClearedParameters()
      {
        ParameterAcceptor::clear();
      }
    };

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
    : public testing::TestWithParam<std::tuple<Formulation, CellType>>
  {};
} // namespace



TEST_P(ManufacturedStatic, ConvergesWithTheOrdersOfLinearElements)
{
  const auto errors = [](const unsigned int n_cells) {
    const auto [formulation, cell_type] = GetParam();
    return formulation == Formulation::plane_strain ?
             SettlementRun<PlaneStrain>(cell_type, n_cells).errors() :
             SettlementRun<Axisymmetric>(cell_type, n_cells).errors();
  };
  Errors coarse = errors(8);
  for (const unsigned int n_cells : {16, 32, 64})
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
      // Orders 2 and 1, but for the scatter of irregular meshes.
      EXPECT_GT(displacement_order, 1.85);
      EXPECT_GT(gradient_order, 0.93);
      EXPECT_GT(stress_order, 0.93);
      coarse = fine;
    }
}

INSTANTIATE_TEST_SUITE_P(
  Settings,
  ManufacturedStatic,
  testing::Combine(
    testing::Values(Formulation::plane_strain, Formulation::axisymmetric),
    testing::Values(CellType::triangle, CellType::quadrilateral)));
