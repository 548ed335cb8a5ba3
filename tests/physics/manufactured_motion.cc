#include "../manufactured_motion.h"

#include <gtest/gtest.h>

#include <iostream>

using namespace Sandglass;

namespace
{
  class ManufacturedMotionTest
    : public testing::TestWithParam<std::tuple<Formulation, CellType>>
  {};
} // namespace



TEST_P(ManufacturedMotionTest, ConvergesWhileParticlesStayInTheirCells)
{
  const auto [formulation, cell_type] = GetParam();
  const ManufacturedMotion motion{formulation,
                                  ManufacturedMotion::Form::sheared,
                                  1e-6};
  for (const ForceIntegration integration :
       {ForceIntegration::particles, ForceIntegration::cell})
    {
      MotionErrors coarse =
        ManufacturedRun(motion, cell_type, integration, 8, 4).run();
      for (const unsigned int n_cells : {16, 32, 64})
        {
          ManufacturedRun    run(motion, cell_type, integration, n_cells, 4);
          const MotionErrors fine = run.run();
          EXPECT_EQ(plastic_work(*run.fixture.stage), 0.);
          const double displacement_order =
            std::log2(coarse.displacement / fine.displacement);
          const double stress_order = std::log2(coarse.stress / fine.stress);
          std::cout << name_of(integration) << ": " << n_cells
                    << " cells: displacement error " << fine.displacement
                    << ", order " << displacement_order << "; stress error "
                    << fine.stress << ", order " << stress_order << std::endl;
          EXPECT_GT(displacement_order, 1.85);
          EXPECT_GT(stress_order, 0.93);
          coarse = fine;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
  Settings,
  ManufacturedMotionTest,
  testing::Combine(
    testing::Values(Formulation::plane_strain, Formulation::axisymmetric),
    testing::Values(CellType::triangle, CellType::quadrilateral)));
