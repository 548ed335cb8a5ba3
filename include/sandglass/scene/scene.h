#ifndef sandglass_scene_scene_h
#define sandglass_scene_scene_h

#include <deal.II/base/partitioner.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe.h>
#include <deal.II/fe/mapping.h>

#include <deal.II/grid/reference_cell.h>

#include <sandglass/continuum/formulation.h>
#include <sandglass/scene/partition.h>
#include <sandglass/walls/wall.h>
#include <sandglass/walls/wall_parameters.h>

#include <memory>
#include <vector>

namespace Sandglass
{
  using namespace dealii;

  /**
   * The grid that both stages work on: the whole computational mesh (filled
   * part and fall region) as a triangulation that every rank holds, with scalar
   * linear elements on it. A node of the method is a degree of freedom of this
   * DoFHandler.
   *
   * Cell i of the mesh is the triangulation's active cell with index i, and
   * vertex i its vertex i.
   */
  template <int dim>
  class Scene
  {
  public:
    /**
     * Throws InputError where mesh and walls' parameters don't fit together.
     *
     * @param mesh     the same on each rank.
     * @param walls    the walls' friction and motion.
     * @param gravity  in m/s^2.
     * @param weights  what each cell costs, for ranks to have equal shares; if
     *                 there are none, by the mesh's filled cells.
     */
    Scene(const Mesh<dim>                 &mesh,
          const WallParameters            &walls,
          const Formulation                formulation,
          const unsigned int               particles_per_cell,
          const Tensor<1, dim>            &gravity,
          const MPI_Comm                   communicator,
          const Partitioner                partitioner = Partitioner::metis,
          const std::vector<unsigned int> &weights     = {});

    const Mesh<dim>      mesh;
    const Formulation    formulation;
    const unsigned int   particles_per_cell;
    const Tensor<1, dim> gravity; ///< in m/s^2
    const MPI_Comm       communicator;

    const Partitioner partitioner;
    /// What each cell costs: by this the ranks have shared them out.
    const std::vector<unsigned int> cell_weights;

  private:
    const std::unique_ptr<parallel::TriangulationBase<dim>> partitioned_mesh;

  public:
    parallel::TriangulationBase<dim> &triangulation;
    const ReferenceCell               reference_cell;
    const Mapping<dim>               &mapping;

    /// In order of the standard parts, then of the mesh's named walls.
    const std::vector<Wall<dim>> walls;

    std::unique_ptr<FiniteElement<dim>> finite_element;
    DoFHandler<dim>                     dof_handler;

    /// The nodes that this rank owns, and the ghost nodes of its cells.
    std::shared_ptr<const Utilities::MPI::Partitioner> nodes;

    /// Owner of each active cell, artificial cells included.
    const std::vector<types::subdomain_id> cell_owners;

    /// Lowest and highest y of the filled cells, in m.
    double fill_bottom, fill_top;

    /// 2 for each symmetry plane of a plane section or a body, of which the
    /// grid has one side and the silo both.
    double symmetry_factor;
  };
} // namespace Sandglass

#endif
