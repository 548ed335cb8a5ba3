#ifndef sandglass_flow_updated_lagrangian_motion_rigid_contact_h
#define sandglass_flow_updated_lagrangian_motion_rigid_contact_h

#include <sandglass/flow/updated_lagrangian/motion/moving_grid.h>
#include <sandglass/flow/updated_lagrangian/motion/rigid_walls.h>
#include <sandglass/flow/updated_lagrangian/node_constraints.h>

#include <boost/container/static_vector.hpp>

#include <functional>
#include <vector>

namespace Sandglass
{
  /// What a wall does to one node at the end of a step.
  struct NodeContact
  {
    unsigned int node;             ///< of the grid's mesh
    unsigned int wall;             ///< index in the list of rigid walls
    Point<2>     position;         ///< in m
    double       area;             ///< in m^2 (plane strain: per metre)
    double       normal_force;     ///< F_N in N, compression positive
    double       tangential_force; ///< on the material, along the tangent, N
    bool         is_sliding;
    double       dissipation; ///< by sliding in the step, in J
  };

  /**
   * Unilateral contact with Coulomb friction between the boundary's nodes and
   * straight rigid walls, along which nodes slide, which they leave, and to
   * which they come back (doc/theory.md).
   *
   * As in WallContact, a node that a wall holds trades its equation normal to
   * the wall for its place on the wall's line, so that nothing sinks in, and
   * sticks by the penalty c_T. Walls hold where a node lies on them at the
   * start of a step; update_contact() releases nodes that walls would have to
   * pull, or that have passed a wall's free end, and catches those that have
   * passed a wall within its ends. In a corner two walls hold a node.
   */
  class RigidContact : public NodeConstraints<2>
  {
  public:
    using Vector        = DisplacementVector;
    using NodeEquations = NodeConstraints<2>::NodeEquations;

    /**
     * All arguments but the numbers have to outlive the object. Nodes on
     * boundary edges of a wall's mark are in contact with it.
     *
     * @param constraint_scale    see WallContact, in N/m.
     * @param tangential_penalty  c_T in N/m^3.
     * @param depth  of the material at a point of the section, in m.
     */
    RigidContact(const MovingGrid             &grid,
                 const std::vector<RigidWall> &walls,
                 const double                  constraint_scale,
                 const double                  tangential_penalty,
                 const std::function<double(const Point<2> &)> &depth);

    void
    evaluate(const Vector &force,
             const Vector &displacement,
             const Vector &increment) override;

    const NodeEquations *
    equations_at(const unsigned int local_dof) const override;

    void
    replace_residual(Vector &residual) const override;

    void
    add_stiffness(TangentMatrix<2> &matrix) const override;

    unsigned int
    update_contact(const double load_share) override;

    void
    commit() override;

    void
    restore() override;

    void
    correct_motion(Vector &velocity, Vector &acceleration) const override;

    /// Of all nodes that walls held at the last commit().
    std::vector<NodeContact>
    contacts() const;

    /// Set friction at the start of the next step, in N along the tangent.
    /// @param traction  of a wall at a place, in Pa; limited by nothing.
    void
    set_tangential_traction(
      const std::function<double(const unsigned int wall, const Point<2> &)>
        &traction);

    /// A pull below this, in N, is none.
    double smallest_pull = 0.;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      for (Node &node : nodes)
        {
          archive &node.position_before;
          auto     n = static_cast<unsigned int>(node.touches_before.size());
          archive &n;
          node.touches_before.resize(n);
          for (Touch &touch : node.touches_before)
            archive &touch.wall &touch.area &touch.normal_force &touch
              .tangential_force &touch.tangential_before &touch
              .is_sliding                                &touch.dissipation;
          node.touches = node.touches_before;
        }
    }

  private:
    struct Touch
    {
      unsigned int wall         = 0;
      double       area         = 0.;
      double       normal_force = 0., tangential_force = 0.; ///< in N
      double       tangential_before = 0.; ///< at the start of the step
      bool         is_sliding        = false;
      double       dissipation       = 0.;
    };

    using Touches = boost::container::static_vector<Touch, 2>;

    struct Node
    {
      unsigned int  node; ///< of the mesh
      unsigned int  dof;  ///< the first one
      Point<2>      position, position_before;
      Touches       touches, touches_before;
      unsigned int  n_changes = 0; ///< in the step
      NodeEquations equations;
    };

    void
    evaluate_sliding(Node               &node,
                     const Tensor<1, 2> &force,
                     const Tensor<1, 2> &increment);
    void
    evaluate_corner(Node &node, const Tensor<1, 2> &force);

    /// Whether one of the walls has to let go of a node; lets it go.
    bool
    release(Node &node) const;

    /// Whether a node has passed a wall; it is held then.
    bool
    hold(Node &node) const;

    /// Area of the boundary round a node that faces a wall.
    double
    area_at(const Node &node, const unsigned int wall) const;

    /// Of the mesh's boundary edges at the start of a step.
    void
    find_areas();

    const MovingGrid             &grid;
    const std::vector<RigidWall> &walls;
    const double                  constraint_scale, tangential_penalty;
    const std::function<double(const Point<2> &)> depth;

    std::vector<Node> nodes;
    /// Index in `nodes` by the first degree of freedom.
    std::vector<unsigned int> node_at_dof;

    /// Shortest edge of the boundary, in m.
    double spacing = 0.;

    /// Outward normals of the boundary at a node, times areas, of its edges.
    std::vector<std::vector<Tensor<1, 2>>> faces_at;
  };
} // namespace Sandglass

#endif
