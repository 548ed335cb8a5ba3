#include <sandglass/continuum/plane_strain.h>
#include <sandglass/flow/updated_lagrangian/material_equilibrium.h>
#include <sandglass/material/drucker_prager.h>
#include <sandglass/scene/make_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "static_fixture.h"

using namespace Sandglass;

namespace
{
  /// A small silo with a hopper, where walls meet and nodes slide and stick.
  Mesh<2>
  hopper_mesh(const CellType cell_type, const double element_size)
  {
    dealii::ParameterAcceptor::clear();
    SceneParameters silo;
    silo.half_width        = 0.4;
    silo.wall_height       = 0.8;
    silo.hopper_height     = 0.2;
    silo.outlet_half_width = 0.15;
    silo.fall_region_depth = 0.2;
    silo.element_size      = element_size;
    silo.cell_type         = cell_type;
    return make_mesh<2>(silo, MPI_COMM_WORLD);
  }



  /// So many nodes that multigrid has levels: it begins with 2000 unknowns.
  Mesh<2>
  fine_mesh(const CellType cell_type)
  {
    return hopper_mesh(cell_type, 0.015);
  }



  /// Largest differences on this rank's cells, over the largest stress, and
  /// over the largest displacement.
  struct Difference
  {
    Difference(const StaticFixture &fixture, const StaticFixture &reference)
    {
      double largest_stress = 0., largest_displacement = 0.;
      fixture.for_each_cell([&](const auto &cell, const auto &state) {
        const auto &other = reference.state.cells[cell->active_cell_index()];
        for (unsigned int q = 0; q < fixture.n_points(); ++q)
          {
            largest_stress = std::max(largest_stress, other.stress[q].norm());
            if (cell->is_locally_owned())
              stress =
                std::max(stress, (state.stress[q] - other.stress[q]).norm());
          }
        for (const unsigned int v : cell->vertex_indices())
          {
            largest_displacement =
              std::max(largest_displacement, other.displacement[v].norm());
            if (cell->is_locally_owned())
              displacement = std::max(
                displacement,
                (state.displacement[v] - other.displacement[v]).norm());
          }
      });
      stress /= largest_stress;
      displacement /= largest_displacement;
      std::cout << "differences: stress " << stress << ", displacement "
                << displacement << std::endl;
    }

    double stress = 0., displacement = 0.;
  };



  /// The tangent of such a silo at a state of compression, with friction.
  struct Tangent
  {
    explicit Tangent(const Mesh<2> &mesh)
      : scene(mesh,
              fixture.walls,
              Formulation::plane_strain,
              4,
              gravity,
              MPI_COMM_WORLD)
      , grid(scene)
      , material(Elasticity(1e6, 0.3), 0.5)
      , equilibrium(grid, material, 1500., gravity)
      , contact(grid, scene, fixture.walls, equilibrium.weight(), 1e6)
    {}

    /// A field that differs from node to node, but is the same on all ranks.
    FilledGrid<2>::Vector
    field(const double compression, const double waves) const
    {
      FilledGrid<2>::Vector result = grid.make_vector();
      result.zero_out_ghost_values();
      for (const auto &cell : grid.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int v : cell->vertex_indices())
            {
              const Point<2> &p = cell->vertex(v);
              result[cell->vertex_dof_index(v, 0)] =
                -0.8 * compression * p[0] + waves * std::sin(9. * p[1] + p[0]);
              result[cell->vertex_dof_index(v, 1)] =
                -compression * p[1] + waves * std::cos(7. * p[0] - p[1]);
            }
      result.compress(VectorOperation::insert);
      result.update_ghost_values();
      return result;
    }

    /// Residual of the equations with contact.
    FilledGrid<2>::Vector
    residual(const FilledGrid<2>::Vector &displacement)
    {
      FilledGrid<2>::Vector forces = grid.make_vector();
      equilibrium.evaluate_forces(displacement, 1., forces);
      contact.evaluate(forces, displacement, displacement);
      forces.zero_out_ghost_values();
      contact.replace_residual(forces);
      return forces;
    }

    const Tensor<1, 2> gravity{{0., -9.81}};
    StaticFixture      fixture; // for the walls' parameters
    Scene<2>           scene;
    FilledGrid<2>      grid;
    DruckerPrager      material;
    MaterialEquilibrium<PlaneStrain, DruckerPrager> equilibrium;
    WallContact<2>                                  contact;
  };

  class StaticRanks : public testing::TestWithParam<CellType>
  {};
} // namespace



// Both storages, at all nodes, also where the cells around one belong to
// several ranks.
TEST_P(StaticRanks, TangentIsTheDerivativeOfTheResidual)
{
  Tangent                     tangent(hopper_mesh(GetParam(), 0.05));
  const FilledGrid<2>::Vector u         = tangent.field(0.02, 1e-4);
  const FilledGrid<2>::Vector direction = tangent.field(0.3, 0.2);

  // Central differences: with a step of 1e-7 the error of the second order is
  // 1e-10 or so, that of rounding 1e-8.
  constexpr double      step  = 1e-7;
  FilledGrid<2>::Vector moved = u;
  moved.zero_out_ghost_values();
  moved.add(step, direction);
  moved.update_ghost_values();
  FilledGrid<2>::Vector difference = tangent.residual(moved);
  moved.zero_out_ghost_values();
  moved.add(-2. * step, direction);
  moved.update_ghost_values();
  difference -= tangent.residual(moved);
  difference /= 2. * step;

  tangent.residual(u);
  for (const auto storage :
       {TangentMatrix<2>::Storage::rows, TangentMatrix<2>::Storage::columns})
    {
      TangentMatrix<2> matrix(tangent.grid, storage);
      tangent.equilibrium.assemble_tangent(tangent.contact, 0., matrix);
      FilledGrid<2>::Vector product = tangent.grid.make_vector();
      product.zero_out_ghost_values();
      FilledGrid<2>::Vector argument = direction;
      argument.zero_out_ghost_values();
      matrix.vmult(product, argument);
      product -= difference;
      const double error = product.linfty_norm() / difference.linfty_norm();
      std::cout << "error of the tangent " << error << std::endl;
      EXPECT_LT(error, 1e-6);
    }
}



// Each rank compares its cells with those of a run that it does alone. The
// linear solver takes other iterations on several ranks; Newton's method makes
// the residual 1e-10 of the weight or less whatever they are.
TEST_P(StaticRanks, StateIsThatOfOneRank)
{
  const Mesh<2> mesh = fine_mesh(GetParam());
  for (const unsigned int most_direct_unknowns : {100000, 0})
    {
      StaticFixture divided, alone;
      for (StaticFixture *fixture : {&divided, &alone})
        {
          fixture->parameters.most_direct_unknowns = most_direct_unknowns;
          fixture->parameters.relative_residual    = 1e-12;
        }
      divided.run(mesh);
      alone.run(mesh, MPI_COMM_SELF);

      const Difference difference(divided, alone);
      EXPECT_LT(difference.stress, 1e-10);
      EXPECT_LT(difference.displacement, 1e-10);
      const double lift =
        dealii::Utilities::MPI::sum(divided.lift(), MPI_COMM_WORLD);
      EXPECT_NEAR(lift / alone.lift(), 1., 1e-11);
    }
}



TEST_P(StaticRanks, MultigridFindsWhatTheDirectSolverFinds)
{
  const Mesh<2> mesh = fine_mesh(GetParam());
  StaticFixture direct, multigrid;
  multigrid.parameters.most_direct_unknowns = 0;
  direct.run(mesh);
  multigrid.run(mesh);

  const auto &effort = multigrid.state.effort;
  EXPECT_TRUE(direct.state.effort.is_direct);
  EXPECT_FALSE(effort.is_direct);
  std::cout << effort.n_newton_iterations << " iterations, "
            << effort.n_linear_iterations << " linear" << std::endl;
  // Some six linear iterations each; without a preconditioner hundreds.
  EXPECT_LT(effort.n_linear_iterations, 15 * effort.n_newton_iterations);

  const Difference difference(multigrid, direct);
  EXPECT_LT(difference.stress, 1e-8);
  EXPECT_LT(difference.displacement, 1e-8);
}

INSTANTIATE_TEST_SUITE_P(CellTypes,
                         StaticRanks,
                         testing::Values(CellType::triangle,
                                         CellType::quadrilateral));
