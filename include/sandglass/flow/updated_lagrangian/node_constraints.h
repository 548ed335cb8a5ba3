#ifndef sandglass_flow_updated_lagrangian_node_constraints_h
#define sandglass_flow_updated_lagrangian_node_constraints_h

#include <deal.II/base/tensor.h>

#include <sandglass/flow/updated_lagrangian/element_grid.h>
#include <sandglass/flow/updated_lagrangian/tangent_matrix.h>

namespace Sandglass
{
  /**
   * What nodes have instead of the equation G = 0, where G is a node's
   * out-of-balance force without contact (internal minus external, with its
   * inertia). This class itself leaves all nodes free, as in free fall.
   */
  template <int dim>
  class NodeConstraints
  {
  public:
    using Vector = DisplacementVector;

    virtual ~NodeConstraints() = default;

    /// A node's equations: their residual, and their tangent force_operator
    /// dG/du + stiffness.
    struct NodeEquations
    {
      Tensor<2, dim> force_operator;
      Tensor<2, dim> stiffness; ///< in N/m
      Tensor<1, dim> residual;  ///< in N
    };

    /**
     * Set up all nodes' equations at an iterate.
     *
     * @param force         G, in N, with ghost entries.
     * @param displacement  since the unloaded state, with ghost entries.
     * @param increment     since the start of the step, likewise.
     */
    virtual void
    evaluate(const Vector & /*force*/,
             const Vector & /*displacement*/,
             const Vector & /*increment*/)
    {}

    /// Null for a free node.
    /// @param local_dof  the node's first, see ElementGrid::LocalCell.
    virtual const NodeEquations *
    equations_at(const unsigned int /*local_dof*/) const
    {
      return nullptr;
    }

    /// Overwrite the residual, in owned entries, where nodes are not free.
    virtual void
    replace_residual(Vector & /*residual*/) const
    {}

    /// Add the owned nodes' stiffness.
    virtual void
    add_stiffness(TangentMatrix<dim> & /*matrix*/) const
    {}

    /**
     * Change which equations nodes have, where the iterate shows that they have
     * the wrong ones. Needs evaluate() at the same iterate.
     *
     * @param load_share  share of gravity that acts.
     * @return number of changes on all ranks.
     */
    virtual unsigned int
    update_contact(const double /*load_share*/)
    {
      return 0;
    }

    /// Keep forces and contact as the start of the next step.
    virtual void
    commit()
    {}

    /// Go back to the start of the step.
    virtual void
    restore()
    {}

    /**
     * Take from nodes the motion that their constraints don't leave them, at
     * the end of a step. Newmark's method with delta = 1/2 would turn a node's
     * velocity round in each step in which a wall holds it.
     *
     * @param velocity,acceleration  owned entries, without ghosts.
     */
    virtual void
    correct_motion(Vector & /*velocity*/, Vector & /*acceleration*/) const
    {}

    /// Turn the rows of a cell's derivative of G into those of its nodes'
    /// equations.
    template <typename Matrix>
    void
    replace_rows(const typename ElementGrid<dim>::LocalCell &local_cell,
                 Matrix                                     &cell_matrix) const
    {
      for (unsigned int i = 0; i < cell_matrix.rows(); i += dim)
        if (const NodeEquations *equations = equations_at(local_cell.dofs[i]))
          {
            Eigen::Matrix<double, dim, dim> force_operator;
            for (unsigned int c = 0; c < dim; ++c)
              for (unsigned int d = 0; d < dim; ++d)
                force_operator(c, d) = equations->force_operator[c][d];
            auto rows = cell_matrix.template middleRows<dim>(i);
            rows      = (force_operator * rows).eval();
          }
    }
  };
} // namespace Sandglass

#endif
