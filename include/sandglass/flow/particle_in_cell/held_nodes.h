#ifndef sandglass_flow_particle_in_cell_held_nodes_h
#define sandglass_flow_particle_in_cell_held_nodes_h

#include <sandglass/flow/particle_in_cell/nodal_fields.h>
#include <sandglass/scene/scene.h>
#include <sandglass/walls/boundary_nodes.h>
#include <sandglass/walls/corner.h>

#include <vector>

namespace Sandglass
{
  /**
   * The boundary's nodes that this rank owns, and in which directions axis and
   * walls hold each of them in this step. A node in a corner obeys all its
   * supports (see corner.h).
   */
  template <int dim>
  class HeldNodes
  {
  public:
    HeldNodes(const Scene<dim> &scene, const WallParameters &parameters);

    /**
     * Take away the part of the mapped velocity v^L that points into a wall or
     * off the axis. Particles that follow it cannot pass the wall, and the
     * strain at the wall is that of material which stays inside.
     */
    void
    constrain(NodalField<dim> &velocity) const;

    /// Set to zero what a nodal field has in the directions in which the nodes
    /// are held.
    void
    release_held(NodalField<dim> &field) const;

    /// Like release_held(), but only where the axis or a fixed corner holds a
    /// node for ever.
    void
    release_always_held(NodalField<dim> &field) const;

  protected:
    /// Which of a node's supports hold it at this velocity.
    static SupportSet
    holding_supports(const BoundaryNode<dim> &node,
                     const Tensor<1, dim>    &velocity)
    {
      return node.is_free ?
               axis_of(node) :
               Sandglass::holding_supports<dim>(node.supports, velocity);
    }

    /// A node's supports that hold it for ever: axis or symmetry planes.
    static SupportSet
    axis_of(const BoundaryNode<dim> &node)
    {
      SupportSet axis = 0;
      for (unsigned int s = 0; s < node.supports.size(); ++s)
        if (node.supports[s].is_axis)
          axis |= 1u << s;
      return axis;
    }

    /// What is left of a velocity that the given supports hold.
    static Tensor<1, dim>
    held_velocity(const BoundaryNode<dim> &node,
                  const SupportSet         holding,
                  const Tensor<1, dim>    &velocity)
    {
      if (node.is_fixed)
        return {};
      if (holding == 0)
        return velocity;
      if (node.supports.size() == 1) // as nearly all nodes have
        return node.supports[0].tangential(velocity);
      return HeldDirections<dim>(node.supports, holding).left_of(velocity);
    }

    /// What is left of a vector along a support. Beside a symmetry plane in
    /// space that is along the plane, too: friction that left it would push
    /// the node off the plane.
    static Tensor<1, dim>
    along_support(const BoundaryNode<dim> &node,
                  const unsigned int       support,
                  const Tensor<1, dim>    &vector)
    {
      const SupportSet axis = dim == 3 ? axis_of(node) : 0;
      return axis == 0 ?
               node.supports[support].tangential(vector) :
               HeldDirections<dim>(node.supports, axis | 1u << support)
                 .left_of(vector);
    }

    const std::vector<BoundaryNode<dim>> nodes;

    /// Of each node, where it stands in the nodal fields.
    std::vector<unsigned int> field_indices;

    /// Of each node, the supports that hold it.
    std::vector<SupportSet> holding;

  private:
    /// Set to zero what the supports `held(n, value)` hold of a nodal field's
    /// value.
    template <typename Held>
    void
    release(NodalField<dim> &field, const Held &held) const;
  };



  /// A node's numbers in a nodal field as a vector.
  template <int dim>
  Tensor<1, dim>
  vector_at(const NodalField<dim> &field, const unsigned int index)
  {
    const double  *values = field.at(index);
    Tensor<1, dim> vector;
    for (unsigned int d = 0; d < dim; ++d)
      vector[d] = values[d];
    return vector;
  }
} // namespace Sandglass

#endif
