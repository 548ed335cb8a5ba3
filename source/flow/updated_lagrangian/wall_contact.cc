#include <deal.II/base/mpi.h>

#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/updated_lagrangian/wall_contact.h>
#include <sandglass/walls/coulomb.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  namespace
  {
    template <int dim>
    Tensor<1, dim>
    node_value(const DisplacementVector                       &vector,
               const std::array<types::global_dof_index, dim> &dofs)
    {
      Tensor<1, dim> value;
      for (unsigned int d = 0; d < dim; ++d)
        value[d] = vector[dofs[d]];
      return value;
    }

  } // namespace



  template <int dim>
  void
  WallContact<dim>::evaluate(const Vector &force,
                             const Vector &displacement,
                             const Vector &increment)
  {
    for (Node &node : nodes)
      evaluate_node(node,
                    node_value<dim>(force, node.dofs),
                    node_value<dim>(displacement, node.dofs),
                    node_value<dim>(increment, node.dofs));
  }



  template <int dim>
  void
  WallContact<dim>::evaluate_node(Node                 &node,
                                  const Tensor<1, dim> &force,
                                  const Tensor<1, dim> &displacement,
                                  const Tensor<1, dim> &increment) const
  {
    SupportSet   active = 0;
    unsigned int last   = 0;
    for (unsigned int s = 0; s < node.supports.size(); ++s)
      {
        State &state           = node.states[s];
        state.gap              = node.supports[s].normal * displacement;
        state.normal_force     = 0.;
        state.tangential_force = Tensor<1, dim>();
        if (state.is_active)
          {
            active |= 1u << s;
            last = s;
          }
      }

    node.equations = NodeEquations();
    if (n_supports(active) > 1)
      {
        evaluate_corner(node, active, force, displacement);
        if (n_supports(active) < dim)
          add_friction_on_edge(node, active, increment);
      }
    else if (active != 0)
      evaluate_sliding(node.equations,
                       node.supports[last],
                       node.states[last],
                       force,
                       increment);
    else
      {
        node.equations.force_operator = unit_symmetric_tensor<dim>();
        node.equations.residual       = force;
      }
  }



  template <int dim>
  void
  WallContact<dim>::evaluate_corner(Node                 &node,
                                    const SupportSet      active,
                                    const Tensor<1, dim> &force,
                                    const Tensor<1, dim> &displacement) const
  {
    const HeldDirections<dim> held(node.supports, active);
    const auto                shares = held.split(-force);
    for (unsigned int s = 0; s < node.supports.size(); ++s)
      node.states[s].normal_force = shares[s];

    NodeEquations &equations = node.equations;
    for (unsigned int d = 0; d < dim; ++d)
      {
        Tensor<1, dim> direction;
        direction[d]                = 1.;
        const Tensor<1, dim> left   = held.left_of(direction);
        equations.force_operator[d] = left;
        equations.stiffness[d]      = constraint_scale * (direction - left);
      }
    const Tensor<1, dim> free_displacement = held.left_of(displacement);
    equations.residual = constraint_scale * (displacement - free_displacement) +
                         held.left_of(force);
  }



  template <int dim>
  void
  WallContact<dim>::evaluate_sliding(NodeEquations        &equations,
                                     const Support<dim>   &support,
                                     State                &state,
                                     const Tensor<1, dim> &force,
                                     const Tensor<1, dim> &increment) const
  {
    const Tensor<1, dim> &n = support.normal;

    state.normal_force  = -(n * force);
    equations.stiffness = constraint_scale * outer_product(n, n);
    equations.residual  = constraint_scale * state.gap * n;

    const double         mu     = support.friction_coefficient;
    const double         limit  = mu * std::max(state.normal_force, 0.);
    const double         spring = tangential_penalty * support.area;
    const Tensor<1, dim> trial =
      state.tangential_before - spring * support.tangential(increment);
    const Tensor<2, dim> in_plane =
      Tensor<2, dim>(unit_symmetric_tensor<dim>()) - outer_product(n, n);

    // A limit of zero counts as sliding, so that the first iteration is that of
    // smooth walls. From smooth walls Newton's method finds the way; from walls
    // to which the material sticks it doesn't.
    const Friction<dim> friction = coulomb(trial, limit);
    state.tangential_force       = friction.force;
    equations.force_operator     = in_plane;
    if (!friction.is_sliding)
      equations.stiffness += spring * in_plane;
    else if (limit > 0.)
      {
        const Tensor<1, dim> direction = trial / trial.norm();
        equations.force_operator += mu * outer_product(direction, n);
        // In three dimensions the direction turns with the slip.
        if (dim > 2)
          equations.stiffness +=
            spring * limit / trial.norm() *
            (in_plane - outer_product(direction, direction));
      }
    equations.residual += support.tangential(force) - friction.force;
  }



  template <int dim>
  const typename WallContact<dim>::NodeEquations *
  WallContact<dim>::equations_at(const unsigned int local_dof) const
  {
    const unsigned int index = node_at_dof[local_dof];
    return index == numbers::invalid_unsigned_int ? nullptr :
                                                    &nodes[index].equations;
  }



  template <int dim>
  void
  WallContact<dim>::replace_residual(Vector &residual) const
  {
    for (const Node &node : nodes)
      if (node.is_owned)
        for (unsigned int d = 0; d < dim; ++d)
          residual[node.dofs[d]] = node.equations.residual[d];
  }



  template <int dim>
  void
  WallContact<dim>::add_stiffness(TangentMatrix<dim> &matrix) const
  {
    for (const Node &node : nodes)
      if (node.is_owned)
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            matrix.add(node.dofs[i],
                       node.dofs[j],
                       node.equations.stiffness[i][j]);
  }



  template <int dim>
  unsigned int
  WallContact<dim>::update_contact(const double load_share)
  {
    unsigned int n_changes = 0;
    for (Node &node : nodes)
      {
        // Of several supports that pull, the one that pulls most goes first.
        State *released = nullptr;
        for (unsigned int s = 0; s < node.supports.size(); ++s)
          {
            State       &state = node.states[s];
            const double allowed_pull =
              node.weight.norm() +
              std::min(0., node.supports[s].normal * node.weight);
            if (state.is_active && !state.is_bilateral &&
                state.normal_force < -load_share * allowed_pull &&
                (!released || state.normal_force < released->normal_force))
              released = &state;
          }

        bool is_changed = released != nullptr;
        if (released)
          released->is_active = false;
        else
          for (unsigned int s = 0; s < node.supports.size(); ++s)
            if (!node.states[s].is_active && node.states[s].gap > 0.)
              is_changed = node.states[s].is_active = true;
        n_changes += is_changed && node.is_owned;
      }
    return Utilities::MPI::sum(n_changes, communicator);
  }



  template <int dim>
  void
  WallContact<dim>::commit()
  {
    for (Node &node : nodes)
      for (State &state : node.states)
        {
          state.was_active        = state.is_active;
          state.tangential_before = state.tangential_force;
        }
  }



  template <int dim>
  void
  WallContact<dim>::restore()
  {
    for (Node &node : nodes)
      for (State &state : node.states)
        state.is_active = state.was_active;
  }



  template <int dim>
  std::vector<WallForce<dim>>
  WallContact<dim>::wall_forces() const
  {
    std::vector<WallForce<dim>> forces;
    for (const Node &node : nodes)
      for (unsigned int s = 0; s < node.supports.size(); ++s)
        {
          const Support<dim> &support   = node.supports[s];
          const State        &state     = node.states[s];
          const bool          is_vertex = node.vertices[0] == node.vertices[1];
          const double        part      = is_vertex ? 1. : 0.5;
          for (const WallShare &share : support.walls)
            for (unsigned int v = 0; v < (is_vertex ? 1 : 2); ++v)
              if (node.is_owned)
                forces.push_back(
                  {share.wall,
                   node.vertices[v],
                   support.normal,
                   part * share.area,
                   part * (-share.of_normal_force * state.normal_force *
                             support.normal +
                           share.of_friction * state.tangential_force)});
        }
    return forces;
  }



#define INSTANTIATE(dim) template class WallContact<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
