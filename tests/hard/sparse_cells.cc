#include <gtest/gtest.h>

#include "small_silo.h"

using namespace Sandglass;

namespace
{
  class SparseCells : public testing::TestWithParam<Formulation>
  {
  protected:
    SparseCells()
    {
      silo.scene.formulation         = GetParam();
      silo.scene.element_size        = 0.025;
      silo.scene.outlet_element_size = 0.003125;
    }

    /// The mean share of cells without a particle over ten instants, of those
    /// whose middle lies in the flow above the outlet.
    double
    holes(const SplitParticles when)
    {
      silo.fixture.parameters.split_particles = when;
      silo.start();
      unsigned int n_cells = 0, n_holes = 0;
      for (unsigned int i = 0; i < 10; ++i)
        {
          silo.expect_sound_flow_until(0.15 + 0.02 * i);
          for (const auto &cell :
               silo.fixture.scene->triangulation.active_cell_iterators())
            if (is_in_flow(cell->center()))
              {
                ++n_cells;
                n_holes += silo.fixture.stage->particles().blocks().first_block(
                             cell->active_cell_index()) ==
                           Sandglass::ParticleBlocks<StageLayout>::none;
              }
        }
      const double share = static_cast<double>(n_holes) / n_cells;
      std::cout << "cells without a particle " << share << std::endl;
      return share;
    }

    bool
    is_in_flow(const Point<2> &point) const
    {
      const double width = silo.scene.outlet_half_width;
      return point[0] < 0.8 * width && point[1] > 0. && point[1] < width;
    }

    SmallSilo silo;
  };
} // namespace



// Cells at the lip have 1/64 of the area of those where most of the material
// comes from.
TEST_P(SparseCells, SplittingKeepsSmallCellsFilled)
{
  EXPECT_LT(holes(SplitParticles::where_needed), 0.06);
  EXPECT_GT(holes(SplitParticles::never), 0.1);
}



INSTANTIATE_TEST_SUITE_P(Formulations,
                         SparseCells,
                         testing::Values(Formulation::plane_strain,
                                         Formulation::axisymmetric));
