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
   * What each cell costs in a step before any flow: the unit is a step's fixed
   * part, of each cell.
   */
  std::vector<unsigned int>
  cell_weights(const Mesh &mesh, const unsigned int particles_per_cell);

  /**
   * The same where cells have come to hold so many particles.
   *
   * @param n_particles  in each cell.
   */
  std::vector<unsigned int>
  cell_weights(const std::vector<unsigned int> &n_particles);

  /**
   * Make a triangulation of `mesh` as triangulate() does, of which each rank
   * holds all cells, and owns those that are shared out to it. Collective.
   *
   * @param weights  what each cell costs: ranks get equal shares.
   */
  std::unique_ptr<parallel::TriangulationBase<dim>>
  partition(const Mesh                      &mesh,
            const std::vector<unsigned int> &weights,
            const Partitioner                partitioner,
            const MPI_Comm                   communicator);

  /// The rank that owns each active cell, on each rank. Collective.
  std::vector<types::subdomain_id>
  find_cell_owners(const parallel::TriangulationBase<dim> &triangulation);
} // namespace Sandglass

#endif
