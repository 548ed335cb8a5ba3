#include <sandglass/choices.h>
#include <sandglass/flow/particle_in_cell/contact.h>

namespace Sandglass
{
  template <int dim>
  void
  Contact<dim>::cancel_by_image(const BoundaryNode<dim> &node, Tensor<1, dim> &velocity)
  {
    for (const NodeSupport<dim> &support : node.supports)
      if (support.role == BoundaryRole::axis)
        velocity -= (velocity * support.normal) * support.normal;
  }



  template <int dim>
  WallArea
  Contact<dim>::wall_area() const
  {
    WallArea area{0., 0.};
    for (unsigned int n = 0; n < nodes.size(); ++n)
      for (unsigned int s = 0; s < nodes[n].boundary.supports.size(); ++s)
        {
          const NodeSupport<dim> &support = nodes[n].boundary.supports[s];
          const bool         touches = (nodes[n].holding >> s & 1u) != 0;
          if (!touches || support.role == BoundaryRole::axis)
            continue;
          area.touching += support.tributary_area;
          if (memories[n][s].is_sliding)
            area.sliding += support.tributary_area;
        }
    return area;
  }



#define INSTANTIATE(dim) \
  template class Contact<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
