#include <deal.II/fe/fe_values.h>

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/trilinos_solver.h>

#include <sandglass/continuum/solid.h>
#include <sandglass/flow/updated_lagrangian/material_equilibrium.h>
#include <sandglass/flow/updated_lagrangian/wall_contact.h>
#include <sandglass/material/drucker_prager.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "box_mesh.h"
#include "solid_fixture.h"

using namespace Sandglass;

namespace
{
  constexpr double inner = 1., outer = 2., height = 0.5, pressure_inside = 1e3;
  constexpr double young_modulus = 1e6, poisson_ratio = 0.3;
  constexpr double right_angle = numbers::PI / 2.;

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

  double
  radius(const Point<3> &point)
  {
    return std::hypot(point[0], point[2]);
  }

  /// Root mean squares: the corners of tetrahedra at the inner edge have larger
  /// errors, which take longer to settle.
  struct Errors
  {
    double displacement = 0.; ///< over that of the inner surface
    double hoop         = 0.; ///< over the largest stress
  };

  /**
   * A quarter of a ring with pressure inside, between two symmetry planes and
   * two smooth plates that keep its height. As in
   * axisymmetric_thick_cylinder.cc it is linear elasticity: the tangent at zero
   * stress.
   */
  class QuarterOfRing
  {
  public:
    /// @param n  cells through the wall, and around the quarter.
    QuarterOfRing(const CellType cell_type, const unsigned int n)
      : n(n)
      , scene(mesh(cell_type),
              fixture.walls,
              Formulation::three_dimensions,
              1,
              Tensor<1, 3>(),
              MPI_COMM_WORLD)
      , grid(scene)
      , material(Elasticity(young_modulus, poisson_ratio), 0.5)
      , equilibrium(grid, material, 1500., scene.gravity)
      , contact(grid, scene, fixture.walls, equilibrium.weight(), young_modulus)
    {}

    Errors
    errors()
    {
      const FilledGrid<3>::Vector displacement = solve();
      FilledGrid<3>::Vector       forces       = grid.make_vector();
      equilibrium.evaluate_forces(displacement, 0., forces);

      Errors       result;
      unsigned int n_points = 0;
      FEValues<3>  fe_values(grid.mapping,
                            grid.finite_element,
                            grid.quadrature,
                            update_quadrature_points);
      for (const auto &cell : grid.dof_handler.active_cell_iterators())
        {
          for (const unsigned int v : cell->vertex_indices())
            {
              const Point<3> &at       = cell->vertex(v);
              const double    expected = radial_displacement(radius(at));
              Tensor<1, 3>    error;
              for (unsigned int d = 0; d < 3; ++d)
                error[d] = displacement[cell->vertex_dof_index(v, d)] -
                           (d == 1 ? 0. : at[d] / radius(at) * expected);
              result.displacement +=
                error.norm_square() / std::pow(radial_displacement(inner), 2) /
                (cell->n_vertices() * grid.triangulation.n_active_cells());
            }
          fe_values.reinit(cell);
          for (const unsigned int q : fe_values.quadrature_point_indices())
            {
              const auto &point =
                equilibrium.material_points()[grid.point_index(*cell, q)];
              const auto stress =
                material.predict(SolidResponse::increment(point.gradient), 0.);
              const Point<3> &at = fe_values.quadrature_point(q);
              const double    r = radius(at), c = at[0] / r, s = at[2] / r;
              const double    hoop = s * s * stress[Component::xx] +
                                  c * c * stress[Component::zz] -
                                  2. * s * c * stress[Component::xz];
              result.hoop +=
                std::pow((hoop - hoop_stress(r)) / hoop_stress(inner), 2);
              ++n_points;
            }
        }
      result.displacement = std::sqrt(result.displacement);
      result.hoop         = std::sqrt(result.hoop / n_points);
      return result;
    }

  private:
    /// A box of radii, heights and angles, bent.
    Mesh<3>
    mesh(const CellType cell_type) const
    {
      using Role = BoundaryRole;
      Box box;
      box.cell_type          = cell_type;
      box.lower              = Point<3>(inner, 0., 0.);
      box.upper              = Point<3>(outer, height, right_angle);
      box.n                  = {{n, n / 2, n}};
      box.roles              = {{{{Role::top, Role::top}},
                                 {{Role::floor, Role::floor}},
                                 {{Role::axis, Role::axis}}}};
      box.displaces_boundary = true;
      box.displaced          = [](const Point<3> &p) {
        return Point<3>(p[0] * std::cos(p[2]), p[1], p[0] * std::sin(p[2]));
      };
      return box.mesh();
    }

    /// Nodal forces of the pressure inside, in N, none in the directions in
    /// which symmetry planes hold a node.
    FilledGrid<3>::Vector
    load() const
    {
      constexpr double      rounding = 1e-9;
      FilledGrid<3>::Vector result   = grid.make_vector();
      result.zero_out_ghost_values();
      for (const auto &cell : grid.dof_handler.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          {
            bool is_inside = true;
            for (const unsigned int v : face->vertex_indices())
              is_inside =
                is_inside && radius(face->vertex(v)) < inner + rounding;
            if (!is_inside)
              continue;
            for (const unsigned int v : face->vertex_indices())
              for (const unsigned int d : {0u, 2u})
                if (face->vertex(v)[d] > rounding)
                  result[face->vertex_dof_index(v, d)] +=
                    pressure_inside * face->measure() / face->n_vertices() *
                    face->vertex(v)[d] / inner;
          }
      return result;
    }

    FilledGrid<3>::Vector
    solve()
    {
      const FilledGrid<3>::Vector zero   = grid.make_vector();
      FilledGrid<3>::Vector       forces = grid.make_vector();
      equilibrium.evaluate_forces(zero, 0., forces);
      contact.evaluate(forces, zero, zero);

      TangentMatrix<3> stiffness(grid, TangentMatrix<3>::Storage::rows);
      equilibrium.assemble_tangent(contact, 1., stiffness);

      FilledGrid<3>::Vector          displacement = grid.make_vector();
      SolverControl                  control;
      TrilinosWrappers::SolverDirect solver(control);
      solver.initialize(stiffness.stored_matrix());
      displacement.zero_out_ghost_values();
      solver.solve(displacement, load());
      displacement.update_ghost_values();
      return displacement;
    }

    const unsigned int                        n;
    SolidFixture                              fixture; // for the walls
    Scene<3>                                  scene;
    FilledGrid<3>                             grid;
    DruckerPrager                             material;
    MaterialEquilibrium<Solid, DruckerPrager> equilibrium;
    WallContact<3>                            contact;
  };

  class SolidThickCylinder : public testing::TestWithParam<CellType>
  {};
} // namespace

TEST_P(SolidThickCylinder, ConvergesToLamesSolution)
{
  const Errors coarse = QuarterOfRing(GetParam(), 8).errors();
  const Errors fine   = QuarterOfRing(GetParam(), 16).errors();
  const double displacement_order =
    std::log2(coarse.displacement / fine.displacement);
  const double hoop_order = std::log2(coarse.hoop / fine.hoop);
  std::cout << "displacement error " << fine.displacement << ", order "
            << displacement_order << "; hoop stress error " << fine.hoop
            << ", order " << hoop_order << std::endl;
  // Orders 2 and 1 of linear elements, as they settle.
  EXPECT_GT(displacement_order, 1.8);
  EXPECT_GT(hoop_order, 0.9);
}

INSTANTIATE_TEST_SUITE_P(CellTypes,
                         SolidThickCylinder,
                         testing::Values(CellType::tetrahedron,
                                         CellType::hexahedron));
