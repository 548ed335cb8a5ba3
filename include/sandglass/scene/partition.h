#ifndef sandglass_scene_partition_h
#define sandglass_scene_partition_h

#include <deal.II/distributed/tria_base.h>

#include <sandglass/scene/mesh.h>

#include <memory>
#include <vector>

namespace Sandglass
{
  using namespace dealii;

  /// What shares a mesh's cells out between ranks.
  enum class Partitioner
  {
    metis, ///< the graph of the cells, for few nodes between the ranks
    p4est  ///< deal.II's hierarchical order of the cells; quadrilaterals only
  };

  /**
   * What a cell costs in a step, in particles at rest.
   *
   * @param n_particles  in the cell.
   * @param n_leaving    of these, those that leave it in a step, on average.
   */
  double
  cell_work(const unsigned int n_particles, const double n_leaving = 0.);

  /// The weights of a partition for cells that cost so much.
  /// @param work  of each cell, as cell_work() tells it.
  std::vector<unsigned int>
  cell_weights(const std::vector<double> &work);

  /// The weights of a partition before any flow.
  template <int dim>
  std::vector<unsigned int>
  cell_weights(const Mesh<dim> &mesh, const unsigned int particles_per_cell);

  /**
   * Make a triangulation of `mesh` as triangulate() does, of which each rank
   * holds all cells, and owns those that are shared out to it. Collective.
   *
   * @param weights  what each cell costs: ranks get equal shares.
   */
  template <int dim>
  std::unique_ptr<parallel::TriangulationBase<dim>>
  partition(const Mesh<dim>                 &mesh,
            const std::vector<unsigned int> &weights,
            const Partitioner                partitioner,
            const MPI_Comm                   communicator);

  /// The rank that owns each active cell, on each rank. Collective.
  template <int dim>
  std::vector<types::subdomain_id>
  find_cell_owners(const parallel::TriangulationBase<dim> &triangulation);
} // namespace Sandglass

#endif
