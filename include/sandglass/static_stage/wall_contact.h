#ifndef sandglass_static_stage_wall_contact_h
#define sandglass_static_stage_wall_contact_h

#include <sandglass/static_stage/filled_grid.h>
#include <sandglass/walls/boundary_nodes.h>
#include <sandglass/walls/wall_force.h>

#include <array>
#include <vector>

namespace Sandglass
{
  /**
   * Unilateral contact with Coulomb friction at the nodes of the silo's walls
   * during quasi-static loading, without a penalty in the normal direction.
   *
   * Let G be a node's out-of-balance force without contact (internal minus
   * external). In equilibrium the walls supply it: G = -F_N n + F_T t with the
   * outward normal n and the tangent t. A node in contact therefore trades its
   * two equations G = 0 for
   *
   *     n u = 0                        normal displacement
   *     t G + c_T A t Du - F_T^n = 0   if it sticks
   *     (t + s mu n) G = 0             if it slides; s is the sign of F_T
   *
   * (paper, Sections 2.3 and 4.2; Du: increment since the start of the load
   * step, where the friction force was F_T^n; A: tributary area). Whether a
   * node sticks or slides follows from the current iterate, so that the
   * equations are continuous; which supports are in contact changes only by
   * update_contact().
   *
   * A node with two supports in contact can't move, and they share its force
   * along their two normals.
   */
  class WallContact
  {
  public:
    using Vector = FilledGrid::Vector;

    /**
     * @param constraint_scale  stiffness in N/m by which equations of normal
     *                          displacement are multiplied, so that they are
     *                          of the size of the others.
     */
    WallContact(const FilledGrid     &grid,
                const Formulation     formulation,
                const WallParameters &parameters,
                const double          constraint_scale);

    /// The equations of a node at an iterate: operator G + ..., linearised.
    struct NodeEquations
    {
      /// Acts on G, in the residual and in the tangent.
      Tensor<2, dim> force_operator;
      /// Tangent of the rest with respect to the displacement.
      Tensor<2, dim> stiffness;
      Tensor<1, dim> residual;
    };

    /**
     * Set up all nodes' equations at an iterate.
     *
     * @param force         G, in N, with ghost entries.
     * @param displacement  since the unloaded state, with ghost entries.
     * @param increment     since the start of the load step, likewise.
     */
    void
    evaluate(const Vector &force,
             const Vector &displacement,
             const Vector &increment);

    /// Null for a vertex without support.
    const NodeEquations *
    equations_at(const unsigned int vertex_index) const;

    /// Overwrite the residual, in owned entries, where nodes are supported.
    void
    replace_residual(Vector &residual) const;

    /// Call `add(dof_i, dof_j, value)` for the owned nodes' stiffness.
    template <typename Function>
    void
    add_stiffness(const Function &add) const;

    /**
     * Release supports that would pull, and close those that the displacement
     * has passed. Needs evaluate() at the same iterate.
     *
     * @return number of changes on all ranks.
     */
    unsigned int
    update_contact();

    /// The weight at the nodes that update_contact() measures forces by, in N,
    /// with ghost entries.
    void
    set_weight(const Vector &weight);

    /// Keep forces and contact as the start of the next load step.
    void
    commit();
    /// Go back to the start of the load step.
    void
    restore();

    /// Of the owned nodes.
    std::vector<WallForce>
    wall_forces() const;

  private:
    struct Support
    {
      BoundaryRole   role;
      Tensor<1, dim> normal, tangent;
      double         tributary_area;
      bool           is_bilateral;

      bool   is_active         = true;
      double gap               = 0.; ///< normal displacement, in m
      double normal_force      = 0.; ///< F_N in N
      double tangential_force  = 0.; ///< F_T in N
      bool   was_active        = true;
      double tangential_before = 0.; ///< F_T^n in N
    };

    struct Node
    {
      Point<dim>                              position;
      std::array<types::global_dof_index, dim> dofs;
      bool                                    is_owned;
      std::vector<Support>                    supports;
      NodeEquations                           equations;
      double                                  weight = 0.; ///< in N
    };

    void
    evaluate_single(Node                 &node,
                    Support              &support,
                    const Tensor<1, dim> &force,
                    const Tensor<1, dim> &increment) const;
    void
    evaluate_node(Node                 &node,
                  const Tensor<1, dim> &force,
                  const Tensor<1, dim> &displacement,
                  const Tensor<1, dim> &increment) const;

    const MPI_Comm            communicator;
    const double              friction_coefficient;
    const double              tangential_penalty;
    const double              constraint_scale;
    std::vector<Node>         nodes;
    std::vector<unsigned int> node_at_vertex;
  };



  template <typename Function>
  void
  WallContact::add_stiffness(const Function &add) const
  {
    for (const Node &node : nodes)
      if (node.is_owned)
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            add(node.dofs[i], node.dofs[j], node.equations.stiffness[i][j]);
  }
} // namespace Sandglass

#endif
