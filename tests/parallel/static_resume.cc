#include <deal.II/base/mpi.h>

#include <sandglass/run/flow_state.h>
#include <sandglass/scene/make_mesh.h>

#include <gtest/gtest.h>

#include "static_fixture.h"

using namespace Sandglass;

namespace
{
  /// Where walls meet and nodes slide and stick.
  struct HopperAtRest : StaticFixture
  {
    explicit HopperAtRest(const CellType cell_type)
    {
      silo.half_width        = 0.4;
      silo.wall_height       = 0.8;
      silo.hopper_height     = 0.2;
      silo.outlet_half_width = 0.15;
      silo.fall_region_depth = 0.2;
      silo.element_size      = 0.05;
      silo.cell_type         = cell_type;
      mesh                   = make_mesh<2>(silo, MPI_COMM_WORLD);
      scene                  = std::make_unique<Scene<2>>(
        mesh, walls, formulation, 4, gravity, MPI_COMM_WORLD);
    }

    std::unique_ptr<StaticStage<2>>
    make_stage()
    {
      return std::make_unique<StaticStage<2>>(
        *scene, material, walls, parameters, log);
    }

    Mesh<2>                    mesh;
    dealii::ConditionalOStream log{log_text};
  };

  class StaticResume : public testing::TestWithParam<CellType>
  {};
} // namespace



TEST_P(StaticResume, GoesOnToTheSameState)
{
  HopperAtRest fixture(GetParam());
  const auto   whole = fixture.make_stage(), parts = fixture.make_stage();
  const auto   reference = whole->run();

  parts->step();
  parts->step();
  EXPECT_FALSE(parts->is_finished());
  const auto resumed = fixture.make_stage();
  hand_over(*parts, *resumed, MPI_COMM_WORLD);
  EXPECT_EQ(resumed->view().clock().step, 2);
  const auto state = resumed->run();

  // The factors of an earlier tangent are not in the checkpoint, so Newton's
  // method gets there by other iterations.
  fixture.for_each_cell([&](const auto &cell, const auto &) {
    if (!cell->is_locally_owned())
      return;
    const auto &a = state.cells[cell->active_cell_index()];
    const auto &b = reference.cells[cell->active_cell_index()];
    for (unsigned int i = 0; i < fixture.n_points(); ++i)
      {
        EXPECT_NEAR((a.displacement[i] - b.displacement[i]).norm(), 0., 1e-12);
        EXPECT_NEAR((a.stress[i] - b.stress[i]).norm() / 1e4, 0., 1e-7);
        EXPECT_NEAR(a.volume_ratio[i], b.volume_ratio[i], 1e-9);
      }
  });
}



TEST_P(StaticResume, ViewShowsMassAndForces)
{
  HopperAtRest fixture(GetParam());
  const auto   stage   = fixture.make_stage();
  fixture.state        = stage->run();
  const FlowView &view = stage->view();

  const double weight = Utilities::MPI::sum(
    [&]() {
      double lift = 0.;
      for (const auto &record : view.wall_records().records)
        lift += record.impulse[1];
      return lift;
    }(),
    MPI_COMM_WORLD);
  EXPECT_EQ(view.wall_records().time, 1.);
  EXPECT_NEAR(weight / (9.81 * view.totals().mass_in_silo), 1., 1e-9);
  // Of trapezium and rectangle
  EXPECT_NEAR(view.totals().mass_in_silo /
                (1500. * (0.5 * (0.15 + 0.4) * 0.2 + 0.4 * 0.8)),
              1.,
              1e-12);

  const GridRecords grid = view.grid();
  EXPECT_EQ(grid.nodes_of_cells.size(),
            grid.cells.size() * grid.nodes_per_cell);
  const unsigned int n_cells =
    Utilities::MPI::sum(static_cast<unsigned int>(grid.cells.size()),
                        MPI_COMM_WORLD);
  unsigned int n_filled = 0;
  for (const auto &cell : fixture.mesh.cells)
    n_filled += cell.is_filled;
  EXPECT_EQ(n_cells, n_filled);
  EXPECT_EQ(view.n_particles(), 0);
}



INSTANTIATE_TEST_SUITE_P(CellTypes,
                         StaticResume,
                         testing::Values(CellType::triangle,
                                         CellType::quadrilateral));
