#include <deal.II/base/mpi.h>

#include <sandglass/choices.h>
#include <sandglass/flow/updated_lagrangian/wall_contact.h>

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



    /// Coefficients a_i of a = a_1 n_1 + a_2 n_2.
    std::array<double, 2>
    split(const Tensor<1, 2> &a, const Tensor<1, 2> &n_1, const Tensor<1, 2> &n_2)
    {
      const auto cross = [](const Tensor<1, 2> &b, const Tensor<1, 2> &c) {
        return b[0] * c[1] - b[1] * c[0];
      };
      const double determinant = cross(n_1, n_2);
      Assert(std::abs(determinant) > 1e-8, ExcInternalError());
      return {{cross(a, n_2) / determinant, cross(n_1, a) / determinant}};
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
    std::vector<Support *> active;
    for (Support &support : node.supports)
      {
        support.gap              = support.normal * displacement;
        support.normal_force     = 0.;
        support.tangential_force = 0.;
        if (support.is_active)
          active.push_back(&support);
      }

    node.equations = NodeEquations();
    if (active.size() == 2)
      evaluate_held(
        node.equations, *active[0], *active[1], force, displacement);
    else if (active.size() == 1)
      evaluate_sliding(node.equations, *active[0], force, increment);
    else
      {
        node.equations.force_operator = unit_symmetric_tensor<dim>();
        node.equations.residual       = force;
      }
  }



  template <int dim>
  void
  WallContact<dim>::evaluate_held(NodeEquations        &equations,
                             Support              &first,
                             Support              &second,
                             const Tensor<1, dim> &force,
                             const Tensor<1, dim> &displacement) const
  {
    const auto shares   = split(-force, first.normal, second.normal);
    first.normal_force  = shares[0];
    second.normal_force = shares[1];
    equations.stiffness = constraint_scale * unit_symmetric_tensor<dim>();
    equations.residual  = constraint_scale * displacement;
  }



  template <int dim>
  void
  WallContact<dim>::evaluate_sliding(NodeEquations        &equations,
                                Support              &support,
                                const Tensor<1, dim> &force,
                                const Tensor<1, dim> &increment) const
  {
    const Tensor<1, dim> &n = support.normal;
    const Tensor<1, dim> &t = support.tangent;

    support.normal_force = -(n * force);
    equations.stiffness  = constraint_scale * outer_product(n, n);
    equations.residual   = constraint_scale * support.gap * n;

    const double mu =
      support.role == BoundaryRole::axis ? 0. : friction_coefficient;
    const double limit  = mu * std::max(support.normal_force, 0.);
    const double spring = tangential_penalty * support.tributary_area;
    const double trial  = support.tangential_before - spring * (t * increment);

    // A limit of zero counts as sliding, so that the first iteration is that
    // of smooth walls. From there Newton's method finds the way, which it
    // doesn't from walls to which the material sticks.
    Tensor<1, dim> direction = t;
    if (std::abs(trial) >= limit)
      {
        support.tangential_force = std::copysign(limit, trial);
        if (limit > 0.)
          direction += std::copysign(mu, trial) * n;
      }
    else
      {
        support.tangential_force = trial;
        equations.stiffness += spring * outer_product(t, t);
      }
    equations.force_operator = outer_product(t, direction);
    equations.residual += (t * force - support.tangential_force) * t;
  }



  template <int dim>
  const typename WallContact<dim>::NodeEquations *
  WallContact<dim>::equations_at(const unsigned int vertex_index) const
  {
    const unsigned int index = node_at_vertex[vertex_index];
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
  unsigned int
  WallContact<dim>::update_contact(const double load_share)
  {
    unsigned int n_changes = 0;
    for (Node &node : nodes)
      {
        // Of two supports that pull, the one that pulls more goes first.
        Support *released = nullptr;
        for (Support &support : node.supports)
          if (support.is_active && !support.is_bilateral &&
              support.normal_force < -load_share * node.weight.norm() &&
              (!released || support.normal_force < released->normal_force))
            released = &support;

        bool is_changed = released != nullptr;
        if (released)
          released->is_active = false;
        else
          for (Support &support : node.supports)
            if (!support.is_active && support.gap > 0.)
              is_changed = support.is_active = true;
        n_changes += is_changed && node.is_owned;
      }
    return Utilities::MPI::sum(n_changes, communicator);
  }



  template <int dim>
  void
  WallContact<dim>::commit()
  {
    for (Node &node : nodes)
      for (Support &support : node.supports)
        {
          support.was_active        = support.is_active;
          support.tangential_before = support.tangential_force;
        }
  }



  template <int dim>
  void
  WallContact<dim>::restore()
  {
    for (Node &node : nodes)
      for (Support &support : node.supports)
        support.is_active = support.was_active;
  }



  template <int dim>
  std::vector<WallForce<dim>>
  WallContact<dim>::wall_forces() const
  {
    std::vector<WallForce<dim>> forces;
    for (const Node &node : nodes)
      for (const Support &support : node.supports)
        if (node.is_owned && is_wall(support.role))
          forces.push_back({node.position,
                            support.role,
                            support.normal,
                            support.tributary_area,
                            support.normal_force,
                            support.tangential_force});
    return forces;
  }



#define INSTANTIATE(dim) \
  template class WallContact<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
