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



  Contact::WallArea
  Contact::wall_area() const
  {
    WallArea area{0., 0.};
    for (unsigned int n = 0; n < nodes.size(); ++n)
      for (unsigned int s = 0; s < nodes[n].boundary.supports.size(); ++s)
        {
          const NodeSupport &support = nodes[n].boundary.supports[s];
          const bool         touches = (nodes[n].holding >> s & 1u) != 0;
          if (!touches || support.role == BoundaryRole::axis)
            continue;
          area.touching += support.tributary_area;
          if (memories[n][s].is_sliding)
            area.sliding += support.tributary_area;
        }
    return area;
  }
} // namespace Sandglass
