#include <deal.II/base/mpi.h>

#include <sandglass/scene/make_mesh.h>
#include <sandglass/scene/scene.h>

#include <gtest/gtest.h>

#include "imbalance.h"

using namespace Sandglass;

namespace
{
  Mesh<2>
  squares()
  {
    SceneParameters silo;
    silo.cell_type    = CellType::quadrilateral;
    silo.element_size = 0.05;
    return make_mesh<2>(silo, MPI_COMM_WORLD);
  }

  class Partition : public testing::TestWithParam<Partitioner>
  {
  protected:
    Partition()
      : scene(squares(),
              WallParameters(),
              Formulation::plane_strain,
              4,
              Tensor<1, 2>(),
              MPI_COMM_WORLD,
              GetParam())
    {}

    const Scene<2> scene;
  };
} // namespace



// Particles, not cells: a fall region of a third of the cells has none.
TEST_P(Partition, SharesParticlesOutEvenly)
{
  EXPECT_LT(imbalance(scene, scene.cell_weights), 1.1);
}



TEST_P(Partition, KeepsTheMeshsOrderOfCells)
{
  const auto &mesh = scene.mesh;
  for (const auto &cell : scene.triangulation.active_cell_iterators())
    {
      Point<2> center;
      for (const unsigned int vertex :
           mesh.cells[cell->active_cell_index()].vertices)
        center += mesh.vertices[vertex] / 4.;
      EXPECT_LT(center.distance(cell->center()), 1e-12);
    }
}



TEST_P(Partition, TellsEachCellsOwnerOnAllRanks)
{
  ASSERT_EQ(scene.cell_owners.size(), scene.mesh.cells.size());
  for (const auto &cell : scene.triangulation.active_cell_iterators())
    EXPECT_EQ(scene.cell_owners[cell->active_cell_index()] ==
                Utilities::MPI::this_mpi_process(MPI_COMM_WORLD),
              cell->is_locally_owned());
}

INSTANTIATE_TEST_SUITE_P(Partitioners,
                         Partition,
                         testing::Values(Partitioner::metis,
                                         Partitioner::p4est));
