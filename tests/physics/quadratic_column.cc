#include <deal.II/fe/fe_values.h>

#include <sandglass/continuum/plane_strain.h>
#include <sandglass/flow/updated_lagrangian/material_equilibrium.h>
#include <sandglass/flow/updated_lagrangian/newton_solver.h>
#include <sandglass/flow/updated_lagrangian/wall_contact.h>
#include <sandglass/material/drucker_prager.h>

#include <gtest/gtest.h>

#include <cmath>

#include "../element_choice.h"
#include "../rectangle_mesh.h"

using namespace Sandglass;

// A column of height H between smooth walls under so little weight that it is
// linear to 1e-6: with the confined modulus M the stress is sigma_y = -rho g (H
// - y), sigma_x = nu / (1 - nu) sigma_y, and u_y = -rho g (H y - y^2 / 2) / M,
// which quadratic elements have exactly.
TEST(QuadraticColumn, IsExact)
{
  constexpr double height = 2., density = 1500.,
                   g = 9.81e-5; // m, kg/m^3, m/s^2
  const Elasticity elasticity(1e6, 0.3);

  ParameterAcceptor::clear();
  const WallParameters        walls;
  const StaticStageParameters parameters;
  Rectangle                   rectangle;
  rectangle.upper = Point<2>(1., height);
  rectangle.left = rectangle.right = BoundaryRole::axis;
  rectangle.bottom                 = BoundaryRole::axis;
  rectangle.displaced              = [](const Point<2> &p) {
    return p + Tensor<1, 2>({0.07 * std::sin(17. * p[0] + 5. * p[1]),
                             0.06 * std::cos(11. * p[0] - 7. * p[1])});
  };
  const Tensor<1, 2>                              gravity({0., -g});
  const Scene<2>                                  scene(rectangle.mesh(),
                       walls,
                       Formulation::plane_strain,
                       4,
                       gravity,
                       MPI_COMM_WORLD);
  const FilledGrid<2>                             grid(scene, 2);
  MaterialEquilibrium<PlaneStrain, DruckerPrager> equilibrium(
    grid, DruckerPrager(elasticity, 1.), density, gravity);
  WallContact<2>  contact(grid, scene, walls, equilibrium.weight(), 1e6);
  NewtonSolver<2> solver(grid, equilibrium, contact, parameters);

  DisplacementVector displacement = grid.make_vector();
  ASSERT_TRUE(solver.solve(grid.make_vector(), 1., {100, 100}, displacement)
                .has_converged);

  const double weight = density * g, M = elasticity.confined_modulus();
  for_each_node(grid, [&](const Point<2> &x, const auto &dofs) {
    const double y = x[1];
    EXPECT_NEAR(displacement[dofs[1]],
                -weight * (height * y - y * y / 2.) / M,
                1e-6 * weight * height * height / M);
    EXPECT_NEAR(displacement[dofs[0]], 0., 1e-6 * weight * height * height / M);
  });
  FEValues<2> fe_values(grid.mapping,
                        grid.finite_element,
                        grid.quadrature,
                        update_quadrature_points);
  for (const auto &cell : grid.dof_handler.active_cell_iterators())
    {
      fe_values.reinit(cell);
      for (const unsigned int q : fe_values.quadrature_point_indices())
        {
          const double vertical =
            -weight * (height - fe_values.quadrature_point(q)[1]);
          const double                 lateral = 0.3 / 0.7 * vertical;
          const SymmetricComponents<4> exact(lateral, vertical, lateral, 0.);
          const SymmetricComponents<4> difference =
            equilibrium.point_state(grid.point_index(*cell, q)).stress - exact;
          EXPECT_LT(difference.norm(), 1e-6 * weight * height);
        }
    }
}
