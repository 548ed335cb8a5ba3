#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/particle_in_cell/held_nodes.h>

namespace Sandglass
{
  namespace
  {
    template <int dim>
    std::vector<BoundaryNode<dim>>
    find_owned_nodes(const Scene<dim> &scene, const WallParameters &parameters)
    {
      std::vector<BoundaryNode<dim>> owned;
      for (const auto &node : find_boundary_nodes(
             scene.dof_handler, scene.formulation, scene.walls, parameters))
        if (scene.nodes->in_local_range(node.dof))
          owned.push_back(node);
      return owned;
    }
  } // namespace



  template <int dim>
  HeldNodes<dim>::HeldNodes(const Scene<dim>     &scene,
                            const WallParameters &parameters)
    : nodes(find_owned_nodes(scene, parameters))
    , holding(nodes.size(), 0)
  {
    for (const auto &node : nodes)
      field_indices.push_back(scene.nodes->global_to_local(node.dof));
  }



  template <int dim>
  template <typename Held>
  void
  HeldNodes<dim>::release(NodalField<dim> &field, const Held &held) const
  {
    for (unsigned int n = 0; n < nodes.size(); ++n)
      {
        const Tensor<1, dim> value = vector_at<dim>(field, field_indices[n]);
        const Tensor<1, dim> released =
          held_velocity(nodes[n], held(n, value), value);
        for (unsigned int d = 0; d < dim; ++d)
          field.at(field_indices[n])[d] = released[d];
      }
  }



  template <int dim>
  void
  HeldNodes<dim>::constrain(NodalField<dim> &velocity) const
  {
    release(velocity,
            [this](const unsigned int n, const Tensor<1, dim> &free_velocity) {
              if (holding[n] == all_supports(nodes[n].supports.size()))
                return holding[n];
              // A wall that presses lets a node move neither in nor out, or
              // v^L's noise would pump material off it. The other wall lets
              // nothing in.
              const auto pressed_velocity =
                held_velocity(nodes[n], holding[n], free_velocity);
              return holding[n] | holding_supports(nodes[n], pressed_velocity);
            });
  }



  template <int dim>
  void
  HeldNodes<dim>::release_held(NodalField<dim> &field) const
  {
    release(field, [this](const unsigned int n, const Tensor<1, dim> &) {
      return holding[n];
    });
  }



  template <int dim>
  void
  HeldNodes<dim>::release_always_held(NodalField<dim> &field) const
  {
    release(field, [this](const unsigned int n, const Tensor<1, dim> &) {
      return axis_of(nodes[n]);
    });
  }



#define INSTANTIATE(dim) template class HeldNodes<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
