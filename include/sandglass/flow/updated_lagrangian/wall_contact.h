#ifndef sandglass_flow_updated_lagrangian_wall_contact_h
#define sandglass_flow_updated_lagrangian_wall_contact_h

#include <sandglass/flow/updated_lagrangian/filled_grid.h>
#include <sandglass/flow/updated_lagrangian/node_constraints.h>
#include <sandglass/walls/boundary_nodes.h>
#include <sandglass/walls/corner.h>
#include <sandglass/walls/wall_force.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <array>
#include <map>
#include <vector>

namespace Sandglass
{
  /**
   * Unilateral contact with Coulomb friction at the nodes of the silo's walls
   * during quasi-static loading, without a penalty in the normal direction.
   *
   * Let G be a node's out-of-balance force without contact (internal minus
   * external). In equilibrium the walls supply it: G = -F_N n + F_T with the
   * outward normal n and a force F_T in the wall's plane, into which T = 1 - n
   * n projects. A node in contact therefore trades its equations G = 0 for
   *
   *     n u = 0                      normal displacement
   *     T G + c_T A T Du - F_T^n = 0 if it sticks
   *     T G - mu (-n G) s = 0        if it slides; s is the direction of F_T
   *
   * (paper, Sections 2.3 and 4.2; Du: increment since the start of the load
   * step, where the friction force was F_T^n; A: the support's area). Whether a
   * node sticks or slides follows from the current iterate, so that the
   * equations are continuous; which supports are in contact changes only by
   * update_contact(). Walls that move later are at rest here.
   *
   * A node with several supports in contact keeps what motion their normals
   * leave it, and they share its force along these (see corner.h); along an
   * edge it rubs against both. Where two
   * walls meet, a node starts on the one that carries more of its weight: at
   * the top of a hopper it can slide, and closes the gap to the vertical wall
   * only if it is pushed there. Likewise nothing starts in contact with a
   * ceiling, an insert's lower side: there it would hang, and only slide along.
   * In quadratic elements all supports start in contact: at vertices there is
   * no weight that could tell.
   */
  template <int dim>
  class WallContact : public NodeConstraints<dim>
  {
  public:
    using Vector        = DisplacementVector;
    using NodeEquations = typename NodeConstraints<dim>::NodeEquations;

    /**
     * @param weight            nodal forces of the whole weight in N, with
     *                          ghost entries.
     * @param constraint_scale  stiffness in N/m by which equations of normal
     *                          displacement are multiplied, so that they are
     *                          of the size of the others.
     */
    WallContact(const FilledGrid<dim> &grid,
                const Scene<dim>      &scene,
                const WallParameters  &parameters,
                const Vector          &weight,
                const double           constraint_scale);

    void
    evaluate(const Vector &force,
             const Vector &displacement,
             const Vector &increment) override;

    /// Null for a node without support.
    const NodeEquations *
    equations_at(const unsigned int local_dof) const override;

    void
    replace_residual(Vector &residual) const override;

    void
    add_stiffness(TangentMatrix<dim> &matrix) const override;

    /**
     * Release supports that pull, and close those that the displacement has
     * passed. A pull below the node's own weight is left as it is, without
     * friction: the mesh doesn't resolve it, and at the free surface the
     * released node would often find no other place. From a ceiling the weight
     * itself pulls; it is not allowed for.
     */
    unsigned int
    update_contact(const double load_share) override;

    void
    commit() override;

    void
    restore() override;

    /// Which supports are in contact, node by node.
    std::vector<SupportSet>
    active_supports() const;

    /// Go back to what active_supports() has found.
    void
    set_active_supports(const std::vector<SupportSet> &active);

    /// Wall forces on the owned nodes. Each end of an edge of quadratic
    /// elements has half of what its middle has.
    std::vector<WallForce<dim>>
    wall_forces() const;

    /// Write what commit() has kept; complete on rank 0. Collective. For linear
    /// elements.
    void
    save(boost::archive::binary_oarchive &archive) const;

    /// Go back to what save() has written, on any number of ranks.
    void
    load(boost::archive::binary_iarchive &archive);

  private:
    /// Contact with one support.
    struct State
    {
      /// Can pull as well as push.
      bool is_bilateral = false;

      bool           is_active    = true;
      double         gap          = 0.; ///< normal displacement, in m
      double         normal_force = 0.; ///< F_N in N
      Tensor<1, dim> tangential_force;  ///< F_T in N

      // at the start of the load step
      bool           was_active = true;
      Tensor<1, dim> tangential_before; ///< F_T^n in N
    };

    struct Node
    {
      /// Of the scene's mesh; those of the ends on an edge, else one twice.
      std::array<unsigned int, 2>              vertices;
      std::array<types::global_dof_index, dim> dofs;
      bool                                     is_owned = false;
      Tensor<1, dim>                           weight; ///< in N
      Supports<dim>                            supports;
      std::array<State, dim>                   states; ///< of the supports
      NodeEquations                            equations;
    };

    /// The nodes with their supports, without degrees of freedom.
    /// @return their indices by degree of freedom of FilledGrid::node_handler.
    std::map<types::global_dof_index, unsigned int>
    collect_nodes(const FilledGrid<dim> &grid,
                  const Scene<dim>      &scene,
                  const WallParameters  &parameters);
    /// Let the nodes know their degrees of freedom.
    void
    find_dofs(const FilledGrid<dim>                                 &grid,
              const std::map<types::global_dof_index, unsigned int> &index_of);
    /// Let a node that rests on several walls start on one of them, and open
    /// ceilings, from which the weight pulls.
    void
    open_supports(Node &node) const;

    void
    evaluate_node(Node                 &node,
                  const Tensor<1, dim> &force,
                  const Tensor<1, dim> &displacement,
                  const Tensor<1, dim> &increment) const;
    /// One support in contact: the node can slide along it.
    void
    evaluate_sliding(NodeEquations        &equations,
                     const Support<dim>   &support,
                     State                &state,
                     const Tensor<1, dim> &force,
                     const Tensor<1, dim> &increment) const;
    /// Several supports in contact.
    void
    evaluate_corner(Node                 &node,
                    const SupportSet      active,
                    const Tensor<1, dim> &force,
                    const Tensor<1, dim> &displacement) const;
    /// Of two supports in space, which leave a node a line to slide along: the
    /// walls share the friction by their limits.
    void
    add_friction_on_edge(Node                 &node,
                         const SupportSet      active,
                         const Tensor<1, dim> &increment) const;

    const MPI_Comm    communicator;
    const double      tangential_penalty;
    const double      constraint_scale;
    std::vector<Node> nodes;
    /// By the first degree of freedom's place in this rank's vectors.
    std::vector<unsigned int> node_at_dof;
  };
} // namespace Sandglass

#endif
