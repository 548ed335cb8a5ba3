#include <deal.II/fe/fe_values.h>

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/trilinos_solver.h>

#include <sandglass/continuum/axisymmetric.h>
#include <sandglass/flow/updated_lagrangian/material_equilibrium.h>
#include <sandglass/flow/updated_lagrangian/wall_contact.h>
#include <sandglass/material/drucker_prager.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  constexpr double inner = 1., outer = 2., height = 0.5, pressure_inside = 1e3;
  constexpr double young_modulus = 1e6, poisson_ratio = 0.3;

  /// Lame's solution of a thick-walled cylinder in plane strain.
  const double lame =
    pressure_inside * inner * inner / (outer * outer - inner * inner);

  double
  radial_displacement(const double r)
  {
    return (1. + poisson_ratio) / young_modulus * lame *
           ((1. - 2. * poisson_ratio) * r + outer * outer / r);
  }

  double
  hoop_stress(const double r)
  {
    return lame * (1. + outer * outer / (r * r));
  }

  struct Errors
  {
    double displacement = 0.; ///< largest, over that of the inner surface
    double hoop         = 0.; ///< root mean square, over the largest stress
  };

  /**
   * A ring with pressure inside, between smooth plates that keep its height.
   * The static stage's tangent at zero stress, with the elastic share 1, is the
   * stiffness of linear elasticity, and the law's prediction the elastic
   * stress; so the test has no part in the yield surface.
   */
  class ThickCylinder
  {
  public:
    ThickCylinder(const CellType cell_type, const unsigned int n_cells)
      : scene(mesh(cell_type, n_cells),
              fixture.walls,
              Formulation::axisymmetric,
              4,
              Tensor<1, 2>({0., 0.}),
              MPI_COMM_WORLD)
      , cell_height(2. * height / n_cells)
      , grid(scene)
      , material(Elasticity(young_modulus, poisson_ratio), 0.5)
      , equilibrium(grid, material, 1500., scene.gravity)
      , contact(grid, scene, fixture.walls, equilibrium.weight(), young_modulus)
    {}

    Errors
    errors()
    {
      const FilledGrid<2>::Vector displacement = solve();
      FilledGrid<2>::Vector       forces       = grid.make_vector();
      equilibrium.evaluate_forces(displacement, 0., forces);

      Errors       result;
      unsigned int n_points = 0;
      FEValues<2>  fe_values(grid.mapping,
                            grid.finite_element,
                            grid.quadrature,
                            update_quadrature_points);
      for (const auto &cell : grid.dof_handler.active_cell_iterators())
        {
          for (const unsigned int v : cell->vertex_indices())
            result.displacement =
              std::max(result.displacement,
                       std::abs(displacement[cell->vertex_dof_index(v, 0)] -
                                radial_displacement(cell->vertex(v)[0])) /
                         radial_displacement(inner));
          fe_values.reinit(cell);
          for (const unsigned int q : fe_values.quadrature_point_indices())
            {
              const auto &point =
                equilibrium.material_points()[grid.point_index(*cell, q)];
              const double hoop =
                material.predict(InPlaneResponse::increment(point.gradient),
                                 0.)[Component::zz];
              const double r = fe_values.quadrature_point(q)[0];
              result.hoop +=
                std::pow((hoop - hoop_stress(r)) / hoop_stress(inner), 2);
              ++n_points;
            }
        }
      result.hoop = std::sqrt(result.hoop / n_points);
      return result;
    }

  private:
    static Mesh<2>
    mesh(const CellType cell_type, const unsigned int n_cells)
    {
      Rectangle rectangle;
      rectangle.cell_type = cell_type;
      rectangle.lower     = Point<2>(inner, 0.);
      rectangle.upper     = Point<2>(outer, height);
      rectangle.n_x       = n_cells;
      rectangle.n_y       = n_cells / 2;
      rectangle.left = rectangle.right = BoundaryRole::top;
      rectangle.bottom = rectangle.top = BoundaryRole::floor;
      return rectangle.mesh();
    }

    /// Nodal forces of the pressure inside, in N.
    FilledGrid<2>::Vector
    load() const
    {
      FilledGrid<2>::Vector result = grid.make_vector();
      result.zero_out_ghost_values();
      for (const auto &cell : grid.dof_handler.active_cell_iterators())
        for (const unsigned int v : cell->vertex_indices())
          if (std::abs(cell->vertex(v)[0] - inner) < 1e-12)
            {
              const double y      = cell->vertex(v)[1];
              const bool   is_end = y < 1e-12 || y > height - 1e-12;
              result[cell->vertex_dof_index(v, 0)] =
                pressure_inside * 2. * numbers::PI * inner * cell_height *
                (is_end ? 0.5 : 1.);
            }
      return result;
    }

    FilledGrid<2>::Vector
    solve()
    {
      const FilledGrid<2>::Vector zero   = grid.make_vector();
      FilledGrid<2>::Vector       forces = grid.make_vector();
      equilibrium.evaluate_forces(zero, 0., forces);
      contact.evaluate(forces, zero, zero);

      TangentMatrix<2> stiffness(grid, TangentMatrix<2>::Storage::rows);
      equilibrium.assemble_tangent(contact, 1., stiffness);

      FilledGrid<2>::Vector          displacement = grid.make_vector();
      SolverControl                  control;
      TrilinosWrappers::SolverDirect solver(control);
      solver.initialize(stiffness.stored_matrix());
      displacement.zero_out_ghost_values();
      solver.solve(displacement, load());
      displacement.update_ghost_values();
      return displacement;
    }

    StageFixture  fixture; // for the walls' parameters
    Scene<2>      scene;
    const double  cell_height;
    FilledGrid<2> grid;
    DruckerPrager material;
    MaterialEquilibrium<Axisymmetric, DruckerPrager> equilibrium;
    WallContact<2>                                   contact;
  };

  class ThickCylinderTest : public testing::TestWithParam<CellType>
  {};
} // namespace



TEST_P(ThickCylinderTest, ConvergesToLamesSolution)
{
  // With 8 cells the leading term of the error is (h / r)^2 / 12 of a thick
  // wall's r = 1, h = 1/8: 1e-3.
  Errors coarse = ThickCylinder(GetParam(), 8).errors();
  EXPECT_LT(coarse.displacement, 5e-3);
  for (const unsigned int n_cells : {16, 32, 64})
    {
      const Errors fine = ThickCylinder(GetParam(), n_cells).errors();
      const double displacement_order =
        std::log2(coarse.displacement / fine.displacement);
      const double hoop_order = std::log2(coarse.hoop / fine.hoop);
      std::cout << n_cells << " cells: displacement error " << fine.displacement
                << ", order " << displacement_order << "; hoop stress error "
                << fine.hoop << ", order " << hoop_order << std::endl;
      // Orders 2 and 1 of linear elements, as they settle.
      EXPECT_GT(displacement_order, 1.8);
      EXPECT_GT(hoop_order, 0.9);
      coarse = fine;
    }
}

INSTANTIATE_TEST_SUITE_P(CellTypes,
                         ThickCylinderTest,
                         testing::Values(CellType::triangle,
                                         CellType::quadrilateral));
