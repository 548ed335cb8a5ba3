// Friction where two supports hold a node in space.

#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/updated_lagrangian/wall_contact.h>
#include <sandglass/walls/coulomb.h>

#include <algorithm>

namespace Sandglass
{
  template <int dim>
  void
  WallContact<dim>::add_friction_on_edge(Node                 &node,
                                         const SupportSet      active,
                                         const Tensor<1, dim> &increment) const
  {
    const HeldDirections<dim> held(node.supports, active);
    const auto                is_rough = [&](const unsigned int s) {
      return contains(active, s) && !node.supports[s].is_axis &&
             node.states[s].normal_force > 0.;
    };
    const auto limit_of = [&](const unsigned int s) {
      return node.supports[s].friction_coefficient *
             node.states[s].normal_force;
    };
    double         limit = 0., spring = 0.;
    Tensor<1, dim> friction_before;
    for (unsigned int s = 0; s < node.supports.size(); ++s)
      if (is_rough(s))
        {
          limit += limit_of(s);
          spring += tangential_penalty * node.supports[s].area;
          friction_before += held.left_of(node.states[s].tangential_before);
        }
    if (!(limit > 0.))
      return;

    const Tensor<1, dim> trial =
      friction_before - spring * held.left_of(increment);
    const Friction<dim> friction = coulomb(trial, limit);
    for (unsigned int s = 0; s < node.supports.size(); ++s)
      if (is_rough(s))
        node.states[s].tangential_force = limit_of(s) / limit * friction.force;

    NodeEquations &equations = node.equations;
    equations.residual -= friction.force;
    for (unsigned int d = 0; d < dim; ++d)
      {
        Tensor<1, dim> direction;
        direction[d] = 1.;
        if (!friction.is_sliding)
          equations.stiffness[d] += spring * held.left_of(direction);
        else
          {
            // The limit follows the normal forces, which follow the force.
            const auto shares = held.split(-direction);
            for (unsigned int s = 0; s < node.supports.size(); ++s)
              if (is_rough(s))
                for (unsigned int c = 0; c < dim; ++c)
                  equations.force_operator[c][d] -=
                    node.supports[s].friction_coefficient * shares[s] *
                    friction.force[c] / limit;
          }
      }
  }



#define INSTANTIATE(dim)                                                       \
  template void WallContact<dim>::add_friction_on_edge(Node &,                 \
                                                       SupportSet,             \
                                                       const Tensor<1, dim> &) \
    const;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
