#include <sandglass/continuum/axisymmetric.h>
#include <sandglass/continuum/plane_strain.h>
#include <sandglass/flow/updated_lagrangian/filled_grid.h>
#include <sandglass/flow/updated_lagrangian/material_equilibrium.h>
#include <sandglass/material/drucker_prager.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "element_choice.h"
#include "rectangle_mesh.h"
#include "return_case.h"

using namespace Sandglass;

namespace
{
  const Elasticity elasticity(1e6, 0.3);

  /// An irregular patch of 4 x 4 squares, and nodal forces on it.
  template <typename Kinematics>
  struct Patch
  {
    explicit Patch(const ElementChoice &element)
      : scene(mesh(element.cell_type),
              WallParameters(),
              Kinematics::formulation,
              4,
              gravity,
              MPI_COMM_WORLD)
      , grid(scene, element.order)
      , material(elasticity, 0.5)
      , equilibrium(grid, material, 1500., gravity)
      , forces(grid.make_vector())
    {}

    static Mesh<2>
    mesh(const CellType cell_type)
    {
      Rectangle rectangle;
      rectangle.cell_type = cell_type;
      rectangle.lower     = Point<2>(1., 0.);
      rectangle.upper     = Point<2>(2., 1.);
      rectangle.left      = BoundaryRole::wall;
      rectangle.displaced = [](const Point<2> &p) {
        return p + Tensor<1, 2>({0.07 * std::sin(17. * p[0] + 5. * p[1]),
                                 0.06 * std::cos(11. * p[0] - 7. * p[1])});
      };
      return rectangle.mesh();
    }

    /// The displacement L x.
    FilledGrid<2>::Vector
    linear_field(const Tensor<2, 2> &L) const
    {
      return nodal_field(grid, [&L](const Point<2> &x) { return L * x; });
    }

    /// Largest nodal force inside of the patch, over E times a cell's width.
    double
    largest_inner_force() const
    {
      double largest = 0.;
      for_each_node(grid, [&](const Point<2> &p, const auto &dofs) {
        if (p[0] > 1.01 && p[0] < 1.99 && p[1] > 0.01 && p[1] < 0.99)
          for (const auto dof : dofs)
            largest = std::max(largest, std::abs(forces[dof]));
      });
      return largest / (1e6 * 0.25);
    }

    void
    expect_uniform_stress(const SymmetricComponents<4> &expected) const
    {
      double largest = 0.;
      for (const auto &point : equilibrium.material_points())
        largest = std::max(
          largest,
          (point.stress - expected).template lpNorm<Eigen::Infinity>());
      std::cout << "largest stress difference / stress "
                << largest / expected.norm() << std::endl;
      EXPECT_LT(largest / expected.norm(), 1e-12);
    }

    const Tensor<1, 2>                             gravity{{0., -9.81}};
    Scene<2>                                       scene;
    FilledGrid<2>                                  grid;
    DruckerPrager                                  material;
    MaterialEquilibrium<Kinematics, DruckerPrager> equilibrium;
    FilledGrid<2>::Vector                          forces;
  };

  Tensor<2, 2>
  tensor(const double xx, const double xy, const double yx, const double yy)
  {
    return Tensor<2, 2>({{xx, xy}, {yx, yy}});
  }

  class PatchTest : public testing::TestWithParam<ElementChoice>
  {};
} // namespace



// Two load steps in a row: in the second, the reference is the deformed patch,
// where the field (I + L_1) x -> L_2 (I + L_1) x has the gradient L_2.
TEST_P(PatchTest, UniformStrainNeedsNoInnerForces)
{
  Patch<PlaneStrain> patch(GetParam());
  const Tensor<2, 2> L_1 = tensor(-0.010, 0.004, 0.002, -0.014);
  const Tensor<2, 2> L_2 = tensor(0.016, -0.003, 0.001, -0.020);

  const auto first = patch.linear_field(L_1);
  patch.equilibrium.evaluate_forces(first, 0., patch.forces);
  const SymmetricComponents<4> elastic =
    elasticity.stress(SymmetricComponents<4>(-0.010, -0.014, 0., 0.003));
  patch.expect_uniform_stress(elastic);
  EXPECT_LT(patch.largest_inner_force(), 1e-14);

  patch.equilibrium.start_step();
  patch.equilibrium.evaluate_forces(patch.linear_field(
                                      L_2 * (L_1 + unit_symmetric_tensor<2>())),
                                    0.,
                                    patch.forces);
  SymmetricComponents<4> plastic =
    elastic + jaumann_rotation(elastic, 0.002) +
    elasticity.stress(SymmetricComponents<4>(0.016, -0.020, 0., -0.001));
  const SymmetricComponents<4> trial = plastic;
  patch.material.project(plastic);
  ASSERT_EQ(case_of(trial, plastic), ReturnCase::yielding);
  patch.expect_uniform_stress(plastic);
  EXPECT_LT(patch.largest_inner_force(), 1e-14);

  // J = det(I + L_2) det(I + L_1)
  const double ratio =
    (1.016 * 0.980 + 0.003 * 0.001) * (0.990 * 0.986 - 0.004 * 0.002);
  for (const auto &point : patch.equilibrium.material_points())
    EXPECT_NEAR(point.volume_ratio / ratio, 1., 1e-13);
}



TEST_P(PatchTest, TranslationAndRotationNeedNoForces)
{
  Patch<PlaneStrain>    patch(GetParam());
  constexpr double      angle = 1e-6;
  FilledGrid<2>::Vector field =
    patch.linear_field(tensor(std::cos(angle) - 1.,
                              -std::sin(angle),
                              std::sin(angle),
                              std::cos(angle) - 1.));
  field.zero_out_ghost_values();
  field.add(0.3); // in both directions
  field.update_ghost_values();
  patch.equilibrium.evaluate_forces(field, 0., patch.forces);
  EXPECT_LT(patch.forces.linfty_norm() / (1e6 * 0.25), 1e-11);
}



TEST_P(PatchTest, WeightIsThatOfTheUndeformedMaterial)
{
  Patch<PlaneStrain> patch(GetParam());
  EXPECT_NEAR(patch.equilibrium.weight().mean_value() *
                patch.equilibrium.weight().size() / (-9.81 * 1500.),
              1.,
              1e-14);
}

INSTANTIATE_TEST_SUITE_P(Elements,
                         PatchTest,
                         testing::ValuesIn(all_elements),
                         element_name);



// u = a x along the radius strains radius and circumference alike; only on
// triangles is the quadrature exact.
TEST(AxisymmetricPatch, UniformStrainNeedsNoInnerForces)
{
  for (const unsigned int order : {1, 2})
    {
      Patch<Axisymmetric> patch({CellType::triangle, order});
      const auto field = patch.linear_field(tensor(-0.010, 0., 0., -0.014));
      patch.equilibrium.evaluate_forces(field, 0., patch.forces);
      patch.expect_uniform_stress(
        elasticity.stress(SymmetricComponents<4>(-0.010, -0.014, -0.010, 0.)));
      EXPECT_LT(patch.largest_inner_force(), 1e-13);
    }
}
