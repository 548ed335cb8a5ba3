#include <gtest/gtest.h>

#include <array>
#include <iostream>

#include "../manufactured_motion.h"

using namespace Sandglass;

namespace
{
  class FiniteMotion
    : public testing::TestWithParam<std::tuple<Formulation, CellType>>
  {
  protected:
    /// Of a motion by 2 % of the square with strains of 6 %: on the finer
    /// meshes, particles cross cells.
    MotionErrors
    errors(const unsigned int n_cells, const unsigned int n_particles) const
    {
      const auto [formulation, cell_type] = GetParam();
      const ManufacturedMotion motion{formulation,
                                      ManufacturedMotion::Form::axis_aligned,
                                      0.02};
      ManufacturedRun          run(motion, cell_type, n_cells, n_particles);
      const MotionErrors       result = run.run();
      std::cout << n_cells << " cells, " << n_particles
                << " particles per cell: displacement error "
                << result.displacement << ", stress error " << result.stress
                << ", plastic work / J "
                << run.fixture.stage->plastic_dissipation << std::endl;
      return result;
    }
  };
} // namespace



// With few particles per cell the sum over them is off by a particle's share
// of the cell where one crosses into the next. That doesn't fall with the
// cells' size, and the difference between neighbours, which is the force,
// grows. With more particles it falls, and with as many more as the cells
// become smaller the method converges again. The pressure that keeps a material
// without cohesion together is part of these sums: twice the largest elastic
// stress here.
TEST_P(FiniteMotion, ConvergesOnlyWithMoreParticlesPerCell)
{
  const MotionErrors coarse = errors(8, 4), middle = errors(16, 16),
                     fine = errors(32, 64);
  const double middle_order =
                 std::log2(coarse.displacement / middle.displacement),
               fine_order = std::log2(middle.displacement / fine.displacement);
  std::cout << "orders with more particles per cell " << middle_order << ", "
            << fine_order << std::endl;
  EXPECT_GT((middle_order + fine_order) / 2., 1.3);

  const MotionErrors middle_with_4 = errors(16, 4), fine_with_4 = errors(32, 4);
  std::cout << "orders with 4 particles per cell "
            << std::log2(coarse.displacement / middle_with_4.displacement)
            << ", "
            << std::log2(middle_with_4.displacement / fine_with_4.displacement)
            << std::endl;
  EXPECT_GT(fine_with_4.displacement, 3. * fine.displacement);
  EXPECT_LT(fine_with_4.displacement, 0.3);
}

// While particles stay in their cells, their volume follows the strain but the
// cell's does not, so that an even pressure gives forces where the strain
// changes, as from a stiffness that the material doesn't have.
// Its share of the displacement is the pressure's over lambda + 2 G, whatever
// the mesh.
TEST_P(FiniteMotion, HasAStiffnessFromAnEvenPressure)
{
  const auto [formulation, cell_type] = GetParam();
  const ManufacturedMotion motion{formulation,
                                  ManufacturedMotion::Form::axis_aligned,
                                  0.005};
  std::array<double, 2>    shares;
  for (const unsigned int mesh : {0u, 1u})
    {
      std::array<double, 2> errors;
      for (const unsigned int i : {0u, 1u})
        errors[i] =
          ManufacturedRun(motion, cell_type, 8u << mesh, 4, 2. + 2. * i)
            .run()
            .displacement;
      shares[mesh] =
        (errors[1] - errors[0]) / (2. * motion.pi * motion.amplitude);
      std::cout << (8u << mesh)
                << " cells: displacement error over pressure / (lambda + 2 G) "
                << shares[mesh] << std::endl;
      EXPECT_GT(shares[mesh], 1.);
      EXPECT_LT(shares[mesh], 2.);
    }
  EXPECT_NEAR(shares[1] / shares[0], 1., 0.1);
}

INSTANTIATE_TEST_SUITE_P(
  Settings,
  FiniteMotion,
  testing::Combine(
    testing::Values(Formulation::plane_strain, Formulation::axisymmetric),
    testing::Values(CellType::triangle, CellType::quadrilateral)));
