#ifndef sandglass_flow_updated_lagrangian_filled_grid_h
#define sandglass_flow_updated_lagrangian_filled_grid_h

#include <deal.II/base/index_set.h>
#include <deal.II/base/quadrature.h>

#include <deal.II/distributed/shared_tria.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <sandglass/scene/scene.h>

#include <array>
#include <memory>
#include <vector>

namespace Sandglass
{
  using namespace dealii;

  /// Numbers at the nodes of a FilledGrid, as many as directions.
  using DisplacementVector = LinearAlgebra::distributed::Vector<double>;

  /**
   * The part of the Scene that material fills at the start, as a grid of its
   * own: linear vector elements for the displacement on a triangulation that
   * is partitioned as the Scene is, so that results go back to the Scene's
   * cells without communication.
   */
  template <int dim>
  class FilledGrid
  {
  public:
    using Vector = DisplacementVector;

    explicit FilledGrid(const Scene<dim> &scene);

    /// A nodal vector field that is zero, with up-to-date ghost entries.
    Vector
    make_vector() const;

    /// A cell that this rank owns, or that shares a node with such a cell.
    struct LocalCell
    {
      typename DoFHandler<dim>::active_cell_iterator cell;
      /// Where its degrees of freedom stand in this rank's vectors; those below
      /// n_owned_dofs() are its own.
      std::array<unsigned int, (dim << dim)> dofs;
    };

    unsigned int
    n_owned_dofs() const
    {
      return owned_dofs.n_elements();
    }

    /// Where values at quadrature point q of a cell stand in arrays of them.
    unsigned int
    point_index(const CellAccessor<dim> &cell, const unsigned int q) const
    {
      return cell.active_cell_index() * quadrature.size() + q;
    }

    /// Direction of a cell's degree of freedom: 0 is x, 1 is y.
    unsigned int
    component(const unsigned int i) const
    {
      return finite_element.system_to_component_index(i).first;
    }

    /// Index in the Scene of each active cell and vertex.
    std::vector<unsigned int> scene_cells, scene_vertices;

    parallel::shared::Triangulation<dim> triangulation;
    const Mapping<dim>                  &mapping;
    const FESystem<dim>                  finite_element;
    /**
     * One point per triangle; in quadrilaterals the centres of four equal
     * parts, where the particle stage's integral has its points too, so that a
     * state in equilibrium here is so there.
     */
    const Quadrature<dim> quadrature;
    /// Displacement; at each vertex the x component comes first.
    DoFHandler<dim> dof_handler;
    /// Scalar, on the same triangulation, as find_boundary_nodes() asks for.
    DoFHandler<dim> node_handler;

    IndexSet owned_dofs, relevant_dofs;

    /**
     * Sums over them are complete at the nodes that this rank owns: work on the
     * ghost cells is done twice, and nothing has to be exchanged.
     */
    std::vector<LocalCell> local_cells;

  private:
    std::shared_ptr<const Utilities::MPI::Partitioner> partitioner;
  };
} // namespace Sandglass

#endif
