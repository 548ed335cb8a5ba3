#ifndef sandglass_walls_boundary_nodes_h
#define sandglass_walls_boundary_nodes_h

#include <deal.II/dofs/dof_handler.h>

#include <sandglass/continuum/formulation.h>
#include <sandglass/walls/support.h>
#include <sandglass/walls/wall_parameters.h>

#include <vector>

namespace Sandglass
{
  using namespace dealii;

  /// A node on the boundary and what supports it there.
  template <int dim>
  struct BoundaryNode
  {
    types::global_dof_index dof = numbers::invalid_dof_index;
    /// Invalid in the middle of an edge.
    unsigned int vertex = numbers::invalid_unsigned_int;
    Point<dim>   position;
    /// Two or more where the boundary's direction jumps.
    Supports<dim> supports;
    /// Whether the node must not move at all (paper, Section 5.1).
    bool is_fixed = false;
    /// Whether it lies on the edge of the open outlet.
    bool is_outlet_lip = false;
    /// Whether its supports do not hold it (a free lip), but only take their
    /// share of the forces that hold particles beside it.
    bool is_free = false;
  };

  /**
   * All nodes on the axis and on walls whose cells this rank knows (owned and
   * ghost cells), in order of their degree of freedom. Open boundaries and the
   * top don't support nodes. Faces of the same direction are one support; in
   * space faces of one wall that turn gradually stand for a curved surface and
   * are one support with their mean direction, and where walls meet in more
   * than three directions the nearest are one. The
   * node at the foot of the wall on a flat floor is marked fixed if the
   * parameters ask for it, that on a free outlet lip free.
   *
   * Throws InputError where the boundary has more directions at a node than
   * the grid, or more than Support::most_walls walls in one of them.
   *
   * @param dof_handler  scalar, linear or in the plane quadratic, on a
   *                     triangulation whose boundary faces are straight and
   *                     have the walls' ids, or those of standard parts.
   */
  template <int dim>
  std::vector<BoundaryNode<dim>>
  find_boundary_nodes(const DoFHandler<dim>        &dof_handler,
                      const Formulation             formulation,
                      const std::vector<Wall<dim>> &walls,
                      const WallParameters         &parameters);
} // namespace Sandglass

#endif
