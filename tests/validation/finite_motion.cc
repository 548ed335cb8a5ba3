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
    struct Result : public MotionErrors
    {
      double plastic_work; ///< in J
    };

    /// Errors of a motion by 2 % of the square with strains of 6 %: on the
    /// finer meshes, particles cross cells.
    Result
    errors(const ForceIntegration integration,
           const unsigned int     n_cells,
           const unsigned int     n_particles) const
    {
      const auto [formulation, cell_type] = GetParam();
      const ManufacturedMotion motion{formulation,
                                      ManufacturedMotion::Form::axis_aligned,
                                      0.02};
      ManufacturedRun run(motion, cell_type, integration, n_cells, n_particles);
      const MotionErrors found = run.run();
      const Result       result{found, plastic_work(*run.fixture.stage)};
      std::cout << name_of(integration) << ": " << n_cells << " cells, "
                << n_particles << " particles per cell: displacement error "
                << result.displacement << ", stress error " << result.stress
                << ", plastic work / J " << result.plastic_work << std::endl;
      return result;
    }

    /// Errors with more particles per cell as the cells' area shrinks.
    std::array<Result, 3>
    errors_with_more_particles(const ForceIntegration integration) const
    {
      return {{errors(integration, 8, 4),
               errors(integration, 16, 16),
               errors(integration, 32, 64)}};
    }

    /// Errors with four particles per cell, on the finer meshes.
    std::array<Result, 2>
    errors_with_four_particles(const ForceIntegration integration) const
    {
      return {{errors(integration, 16, 4), errors(integration, 32, 4)}};
    }
  };

  /// Order between the first mesh and the last, whose cells have a quarter of
  /// the side.
  double
  order(const double coarse, const double fine)
  {
    return std::log2(coarse / fine) / 2.;
  }
} // namespace



// With few particles per cell the sum over their volumes is off by a particle's
// share of the cell where one crosses into the next. That doesn't fall with the
// cells' size, and the difference between neighbours, which is the force,
// grows. With more particles it falls, and with as many more as the cells
// become smaller the method converges again. The pressure that keeps a material
// without cohesion together is part of these sums: twice the largest elastic
// stress here.
//
// Over the cells' own volume the sum is right wherever particles fill the
// cell: errors are smaller, the stresses converge too, and none reaches the
// cone. On the coarsest mesh most of the error that is left is the mesh's.
TEST_P(FiniteMotion, ConvergesWithMoreParticlesPerCell)
{
  const auto paper = errors_with_more_particles(ForceIntegration::particles),
             cell  = errors_with_more_particles(ForceIntegration::cell);
  EXPECT_GT(order(paper[0].displacement, paper[2].displacement), 1.3);
  EXPECT_GT(order(cell[0].displacement, cell[2].displacement), 1.5);
  EXPECT_GT(order(cell[0].stress, cell[2].stress), 1.);
  for (unsigned int mesh = 0; mesh < 3; ++mesh)
    {
      const double factor = mesh == 0 ? 2. : 3.;
      EXPECT_LT(factor * cell[mesh].displacement, paper[mesh].displacement);
      EXPECT_LT(factor * cell[mesh].stress, paper[mesh].stress);
      EXPECT_EQ(cell[mesh].plastic_work, 0.);
    }

  const auto paper_with_4 =
               errors_with_four_particles(ForceIntegration::particles),
             cell_with_4 = errors_with_four_particles(ForceIntegration::cell);
  EXPECT_GT(paper_with_4[1].displacement, 3. * paper[2].displacement);
  EXPECT_LT(paper_with_4[1].displacement, 0.3);
  for (unsigned int mesh = 0; mesh < 2; ++mesh)
    {
      EXPECT_LT(2. * cell_with_4[mesh].displacement,
                paper_with_4[mesh].displacement);
      EXPECT_LT(3. * cell_with_4[mesh].stress, paper_with_4[mesh].stress);
    }
}



namespace
{
  /// How much the displacement's error grows with an even pressure over
  /// lambda + 2 G, on a coarse and a finer mesh.
  class EvenPressure : public FiniteMotion
  {
  protected:
    std::array<double, 2>
    shares(const ForceIntegration integration) const
    {
      const auto [formulation, cell_type] = GetParam();
      const ManufacturedMotion motion{formulation,
                                      ManufacturedMotion::Form::axis_aligned,
                                      0.005};
      std::array<double, 2>    result;
      for (const unsigned int mesh : {0u, 1u})
        {
          const unsigned int    n_cells = 8u << mesh;
          std::array<double, 2> errors;
          for (const unsigned int i : {0u, 1u})
            errors[i] =
              ManufacturedRun(
                motion, cell_type, integration, n_cells, 4, 2. + 2. * i)
                .run()
                .displacement;
          result[mesh] =
            (errors[1] - errors[0]) / (2. * motion.pi * motion.amplitude);
          std::cout << name_of(integration) << ": " << n_cells
                    << " cells: displacement error over pressure / (lambda + "
                       "2 G) "
                    << result[mesh] << std::endl;
        }
      return result;
    }
  };
} // namespace

// While particles stay in their cells, their volume follows the strain but the
// cell's does not, so that an even pressure gives forces where the strain
// changes, as from a stiffness that the material doesn't have.
// Its share of the displacement is the pressure's over lambda + 2 G, whatever
// the mesh.
TEST_P(EvenPressure, IsAStiffnessToTheParticlesVolumes)
{
  const auto shares = this->shares(ForceIntegration::particles);
  for (const double share : shares)
    {
      EXPECT_GT(share, 1.);
      EXPECT_LT(share, 2.);
    }
  EXPECT_NEAR(shares[1] / shares[0], 1., 0.1);
}

// The cells' own volume keeps an even pressure in equilibrium. In rings the
// hoop stress adds an error of the quadrature, which falls with the cells.
TEST_P(EvenPressure, IsNoneToTheCellsVolumes)
{
  const auto shares = this->shares(ForceIntegration::cell);
  if (std::get<Formulation>(GetParam()) == Formulation::plane_strain)
    for (const double share : shares)
      EXPECT_LT(std::abs(share), 0.01);
  else
    {
      EXPECT_LT(std::abs(shares[0]), 0.3);
      EXPECT_LT(std::abs(shares[1]), std::abs(shares[0]) / 2.);
    }
}



namespace
{
  const auto settings = testing::Combine(
    testing::Values(Formulation::plane_strain, Formulation::axisymmetric),
    testing::Values(CellType::triangle, CellType::quadrilateral));
}

INSTANTIATE_TEST_SUITE_P(Settings, FiniteMotion, settings);
INSTANTIATE_TEST_SUITE_P(Settings, EvenPressure, settings);
