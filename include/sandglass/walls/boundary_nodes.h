#ifndef sandglass_walls_boundary_nodes_h
#define sandglass_walls_boundary_nodes_h

#include <deal.II/base/tensor.h>

#include <deal.II/dofs/dof_handler.h>

#include <sandglass/continuum/formulation.h>
#include <sandglass/scene/boundary_role.h>
#include <sandglass/walls/wall_parameters.h>

#include <vector>

namespace Sandglass
{
  using namespace dealii;

  /// One straight stretch of boundary that holds a node.
  template <int dim>
  struct NodeSupport
  {
    BoundaryRole   role;
    Tensor<1, dim> normal; ///< outward from the material, unit length
    /**
     * Area of wall that belongs to the node: half of the adjacent edges of this
     * role and direction, per metre of depth (plane strain) or times the
     * circumference 2 pi x (axisymmetric). In m^2.
     */
    double tributary_area;
  };

  /// A node on the boundary and what supports it there.
  template <int dim>
  struct BoundaryNode
  {
    types::global_dof_index dof;
    Point<dim>              position;
    /// One or two; two where the boundary's direction jumps.
    std::vector<NodeSupport<dim>> supports;
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
   * top don't support nodes. Where two supports have the same direction they
   * are merged; the node at the foot of the wall on a flat floor is marked
   * fixed if the parameters ask for it, that on a free outlet lip free.
   *
   * @param dof_handler  scalar, linear, on a triangulation whose boundary ids
   *                     are BoundaryRole values.
   */
  template <int dim>
  std::vector<BoundaryNode<dim>>
  find_boundary_nodes(const DoFHandler<dim> &dof_handler,
                      const Formulation      formulation,
                      const WallParameters  &parameters);
} // namespace Sandglass

#endif
