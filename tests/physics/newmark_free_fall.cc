#include <sandglass/continuum/axisymmetric.h>
#include <sandglass/continuum/plane_strain.h>
#include <sandglass/flow/updated_lagrangian/material_equilibrium.h>
#include <sandglass/flow/updated_lagrangian/newmark_motion.h>
#include <sandglass/material/drucker_prager.h>

#include <gtest/gtest.h>

#include <cmath>

#include "../element_choice.h"
#include "../rectangle_mesh.h"
#include "cleared_parameters.h"

using namespace Sandglass;

namespace
{
  /// A block of loose material on an uneven mesh that nothing holds, without a
  /// Scene.
  template <typename Kinematics>
  class FallingBlock
  {
  public:
    explicit FallingBlock(const ElementChoice &element)
      : grid(mesh(element.cell_type),
             element.order,
             MPI_COMM_SELF,
             [](const unsigned int) { return 0; })
      , equilibrium(grid,
                    DruckerPrager(Elasticity(1e6, 0.3), 0.5),
                    density,
                    gravity)
      , mass(grid,
             Kinematics::formulation,
             [this](const Point<2> &) { return density; })
      , motion(grid, equilibrium, mass, nothing, {0.05, {}}, solver_parameters)
    {}

    static Mesh<2>
    mesh(const CellType cell_type)
    {
      Rectangle rectangle;
      rectangle.cell_type = cell_type;
      rectangle.left = rectangle.right = BoundaryRole::top;
      rectangle.bottom                 = BoundaryRole::top;
      rectangle.displaced              = [](const Point<2> &p) {
        return p + Tensor<1, 2>({0.07 * std::sin(17. * p[0] + 5. * p[1]),
                                 0.06 * std::cos(11. * p[0] - 7. * p[1])});
      };
      return rectangle.mesh();
    }

    const double                                   density = 1500.;
    const Tensor<1, 2>                             gravity{{0., -9.81}};
    ClearedParameters                              cleared;
    StaticStageParameters                          solver_parameters;
    ElementGrid<2>                                 grid;
    MaterialEquilibrium<Kinematics, DruckerPrager> equilibrium;
    ConsistentMass<2>                              mass;
    NodeConstraints<2>                             nothing;
    NewmarkMotion<2>                               motion;
  };

  class NewmarkFreeFall : public testing::TestWithParam<ElementChoice>
  {};

  /// Newmark's method integrates a steady acceleration exactly.
  template <typename Kinematics>
  void
  expect_free_fall(const ElementChoice &element)
  {
    FallingBlock<Kinematics> block(element);
    auto                    &motion = block.motion;
    const double             rise   = 1.5; // m/s
    const double volume = Kinematics::has_hoop_strain ? numbers::PI : 1.;
    // One point per linear triangle doesn't integrate the radius exactly.
    EXPECT_NEAR(block.mass.total(),
                block.density * volume,
                (Kinematics::has_hoop_strain ? 1e-2 : 1e-12) * block.density *
                  volume);

    motion.start(block.grid.make_vector(),
                 nodal_field(block.grid, [rise](const Point<2> &) {
                   return Tensor<1, 2>({0., rise});
                 }));
    const double start_energy = motion.energies().kinetic;
    for (unsigned int i = 0; i < 10; ++i)
      motion.step();

    const double t = motion.time(), g = 9.81;
    EXPECT_NEAR(t, 0.5, 1e-14);
    for_each_node(block.grid, [&](const Point<2> &, const auto &dofs) {
      EXPECT_NEAR(motion.displacement()[dofs[0]], 0., 1e-8);
      EXPECT_NEAR(motion.displacement()[dofs[1]],
                  rise * t - g * t * t / 2.,
                  1e-8);
      EXPECT_NEAR(motion.velocity()[dofs[1]], rise - g * t, 1e-8);
      EXPECT_NEAR(motion.acceleration()[dofs[1]], -g, 1e-6);
    });
    const auto energies = motion.energies();
    EXPECT_NEAR(energies.kinetic + energies.potential,
                start_energy,
                1e-8 * energies.kinetic);
    EXPECT_LT(energies.elastic, 1e-12 * energies.kinetic);
    EXPECT_EQ(motion.effort().n_failures, 0u);
  }
} // namespace



TEST_P(NewmarkFreeFall, IsExact)
{
  expect_free_fall<PlaneStrain>(GetParam());
  expect_free_fall<Axisymmetric>(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Elements,
                         NewmarkFreeFall,
                         testing::ValuesIn(all_elements),
                         element_name);
