#include <sandglass/particle_stage/contact.h>

namespace Sandglass
{
  void
  Contact::cancel_by_image(const BoundaryNode &node, Tensor<1, dim> &velocity)
  {
    for (const NodeSupport &support : node.supports)
      if (support.role == BoundaryRole::axis)
        velocity -= (velocity * support.normal) * support.normal;
  }



  std::vector<types::global_dof_index>
  Contact::node_dofs() const
  {
    std::vector<types::global_dof_index> dofs;
    for (const auto &node : nodes)
      dofs.push_back(node.boundary.dof);
    return dofs;
  }

} // namespace Sandglass
