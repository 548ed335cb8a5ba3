#ifndef sandglass_flow_updated_lagrangian_element_grid_h
#define sandglass_flow_updated_lagrangian_element_grid_h

#include <deal.II/base/index_set.h>
#include <deal.II/base/quadrature.h>

#include <deal.II/distributed/shared_tria.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <sandglass/scene/mesh.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace Sandglass
{
  using namespace dealii;

  /// Numbers at the nodes of an ElementGrid, as many as directions.
  using DisplacementVector = LinearAlgebra::distributed::Vector<double>;

  /**
   * Material as a grid of finite elements: vector elements for the displacement
   * on a triangulation that every rank holds. Where material is at the start,
   * before any displacement, edges are straight.
   */
  template <int dim>
  class ElementGrid
  {
  public:
    using Vector = DisplacementVector;

    /// The rank that owns a cell of the mesh.
    using CellOwner =
      std::function<types::subdomain_id(const unsigned int cell)>;

    /**
     * Throws InputError as triangulate() does.
     *
     * @param mesh           all of it is material; the same on each rank.
     * @param element_order  1, or 2 for triangles with a node on each edge.
     */
    ElementGrid(const Mesh<dim>   &mesh,
                const unsigned int element_order,
                const MPI_Comm     communicator,
                const CellOwner   &owner);

    /// A nodal vector field that is zero, with up-to-date ghost entries.
    Vector
    make_vector() const;

    /// Degrees of freedom of a cell with linear elements, and with quadratic
    /// ones, which are for triangles.
    static constexpr unsigned int n_simplex_dofs   = dim * (dim + 1);
    static constexpr unsigned int n_cube_dofs      = dim << dim;
    static constexpr unsigned int n_quadratic_dofs = 12;

    /// A cell that this rank owns, or that shares a node with such a cell.
    struct LocalCell
    {
      typename DoFHandler<dim>::active_cell_iterator cell;
      /// Where its degrees of freedom stand in this rank's vectors, node by
      /// node, vertices first; those below n_owned_dofs() are its own.
      std::array<unsigned int, std::max(n_cube_dofs, n_quadratic_dofs)> dofs;
    };

    unsigned int
    n_owned_dofs() const
    {
      return owned_dofs.n_elements();
    }

    /// Degrees of freedom in this rank's vectors, ghost entries included.
    unsigned int
    n_local_dofs() const
    {
      return owned_dofs.n_elements() + partitioner->n_ghost_indices();
    }

    /// Where values at quadrature point q of a cell stand in arrays of them.
    unsigned int
    point_index(const CellAccessor<dim> &cell, const unsigned int q) const
    {
      return cell.active_cell_index() * quadrature.size() + q;
    }

    /// Direction of a cell's degree of freedom: 0 is x, 1 is y, 2 is z.
    unsigned int
    component(const unsigned int i) const
    {
      return finite_element.system_to_component_index(i).first;
    }

    parallel::shared::Triangulation<dim> triangulation;
    const Mapping<dim>                  &mapping;
    const FESystem<dim>                  finite_element;
    /**
     * For stresses. One point per linear triangle or tetrahedron; in
     * quadrilaterals the centres of four equal parts (in hexahedra of eight),
     * where the particle stage's integral has its points too, so that a state
     * in equilibrium here is so there. In quadratic
     * triangles three points in their inside, exact to degree 2, which is that
     * of a straight triangle's stiffness. deal.II's rule of four points would
     * be exact to degree 3, but results would depend on which vertex comes
     * first.
     */
    const Quadrature<dim> quadrature;
    /// For weight and mass: the same in linear elements; in quadratic ones
    /// exact to degree 5, that of their mass about an axis.
    const Quadrature<dim> mass_quadrature;
    /// Displacement; at each node the x component comes first.
    DoFHandler<dim> dof_handler;
    /// Scalar, of the same order, as find_boundary_nodes() asks for.
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
