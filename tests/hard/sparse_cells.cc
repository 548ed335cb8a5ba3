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

    /// The share of cells without a particle, of those whose middle lies in
    /// the flow above the outlet.
    double
    holes_after(const double time, const SplitParticles when)
    {
      silo.fixture.parameters.split_particles = when;
      silo.start();
      silo.expect_sound_flow_until(time);
      unsigned int n_cells = 0, n_holes = 0;
      for (const auto &cell :
           silo.fixture.scene->triangulation.active_cell_iterators())
        {
          const Point<2> middle = cell->center();
          if (middle[0] > 0.8 * silo.scene.outlet_half_width ||
              middle[1] < 0. || middle[1] > silo.scene.outlet_half_width)
            continue;
          ++n_cells;
          n_holes += silo.fixture.stage->cloud.blocks().first_block(
                       cell->active_cell_index()) == ParticleBlocks::none;
        }
      const double share = static_cast<double>(n_holes) / n_cells;
      std::cout << "cells without a particle " << share << std::endl;
      return share;
    }

    SmallSilo silo;
  };
} // namespace



// Cells at the lip have 1/64 of the area of those where most of the material
// comes from.
TEST_P(SparseCells, SplittingKeepsSmallCellsFilled)
{
  EXPECT_LT(holes_after(0.25, SplitParticles::where_needed), 0.03);
  EXPECT_GT(holes_after(0.25, SplitParticles::never), 0.1);
}



INSTANTIATE_TEST_SUITE_P(Formulations,
                         SparseCells,
                         testing::Values(Formulation::plane_strain,
                                         Formulation::axisymmetric));
