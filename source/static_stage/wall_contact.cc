#include <deal.II/base/mpi.h>

#include <sandglass/static_stage/wall_contact.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Sandglass
{
  namespace
  {
    /**
     * Share of a node's weight with which a support may pull before it is
     * released: next to the free surface forces are of the size of rounding, and
     * nodes would come and go.
     */
    constexpr double pull_tolerance = 0.1;



    Tensor<1, dim>
    node_value(const FilledGrid::Vector                        &vector,
               const std::array<types::global_dof_index, dim> &dofs)
    {
      Tensor<1, dim> value;
      for (unsigned int d = 0; d < dim; ++d)
        value[d] = vector[dofs[d]];
      return value;
    }



    /// Coefficients a_i of a = a_1 n_1 + a_2 n_2.
    std::array<double, 2>
    split(const Tensor<1, dim> &a,
          const Tensor<1, dim> &n_1,
          const Tensor<1, dim> &n_2)
    {
      const auto cross = [](const Tensor<1, dim> &b, const Tensor<1, dim> &c) {
        return b[0] * c[1] - b[1] * c[0];
      };
      const double determinant = cross(n_1, n_2);
      Assert(std::abs(determinant) > 1e-8, ExcInternalError());
      return {{cross(a, n_2) / determinant, cross(n_1, a) / determinant}};
    }



    /// Material on the axis can't leave it: there a wall acts along it only.
    void
    align_with_axis(std::vector<NodeSupport> &supports)
    {
      const bool has_axis =
        std::any_of(supports.begin(), supports.end(), [](const auto &support) {
          return support.role == BoundaryRole::axis;
        });
      for (auto &support : supports)
        if (has_axis && support.role != BoundaryRole::axis)
          support.normal = Tensor<1, dim>(
            {0., std::copysign(1., support.normal[1])});
    }
  } // namespace



  WallContact::WallContact(const FilledGrid     &grid,
                           const Formulation     formulation,
                           const WallParameters &parameters,
                           const double          constraint_scale)
    : communicator(grid.triangulation.get_communicator())
    , friction_coefficient(parameters.friction_coefficient())
    , tangential_penalty(parameters.tangential_penalty)
    , constraint_scale(constraint_scale)
    , node_at_vertex(grid.triangulation.n_vertices(),
                     numbers::invalid_unsigned_int)
  {
    std::map<types::global_dof_index, unsigned int> index_of;
    for (BoundaryNode &found : find_boundary_nodes(grid.node_handler,
                                                   formulation,
                                                   parameters))
      {
        align_with_axis(found.supports);
        index_of[found.dof] = nodes.size();
        Node node;
        node.position = found.position;
        for (const NodeSupport &support : found.supports)
          {
            node.supports.push_back({support.role,
                                     support.normal,
                                     wall_tangent(support.normal),
                                     support.tributary_area,
                                     found.is_fixed || support.role ==
                                                         BoundaryRole::axis});
          }
        nodes.push_back(node);
      }

    auto node_cell = grid.node_handler.begin_active();
    for (const auto &cell : grid.dof_handler.active_cell_iterators())
      {
        if (!cell->is_artificial())
          for (const unsigned int v : cell->vertex_indices())
            {
              const auto found =
                index_of.find(node_cell->vertex_dof_index(v, 0));
              if (found == index_of.end())
                continue;
              node_at_vertex[cell->vertex_index(v)] = found->second;
              Node &node                            = nodes[found->second];
              for (unsigned int d = 0; d < dim; ++d)
                node.dofs[d] = cell->vertex_dof_index(v, d);
              node.is_owned = grid.owned_dofs.is_element(node.dofs[0]);
            }
        ++node_cell;
      }
  }



  void
  WallContact::evaluate(const Vector &force,
                        const Vector &displacement,
                        const Vector &increment)
  {
    for (Node &node : nodes)
      evaluate_node(node,
                    node_value(force, node.dofs),
                    node_value(displacement, node.dofs),
                    node_value(increment, node.dofs));
  }



  void
  WallContact::evaluate_node(Node                 &node,
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

    NodeEquations &equations = node.equations;
    equations                = NodeEquations();
    if (active.empty())
      {
        equations.force_operator = unit_symmetric_tensor<dim>();
        equations.residual       = force;
      }
    else if (active.size() == 1)
      evaluate_single(node, *active[0], force, increment);
    else
      {
        const auto shares =
          split(-force, active[0]->normal, active[1]->normal);
        active[0]->normal_force = shares[0];
        active[1]->normal_force = shares[1];
        equations.stiffness = constraint_scale * unit_symmetric_tensor<dim>();
        equations.residual  = constraint_scale * displacement;
      }
  }



  void
  WallContact::evaluate_single(Node                 &node,
                               Support              &support,
                               const Tensor<1, dim> &force,
                               const Tensor<1, dim> &increment) const
  {
    NodeEquations        &equations = node.equations;
    const Tensor<1, dim> &n         = support.normal;
    const Tensor<1, dim> &t         = support.tangent;

    support.normal_force = -(n * force);
    equations.stiffness  = constraint_scale * outer_product(n, n);
    equations.residual   = constraint_scale * support.gap * n;

    const bool is_frictionless =
      support.role == BoundaryRole::axis || friction_coefficient == 0.;
    const double largest =
      is_frictionless ?
        0. :
        friction_coefficient * std::max(support.normal_force, 0.);
    const double spring = tangential_penalty * support.tributary_area;
    const double trial  = support.tangential_before - spring * (t * increment);

    Tensor<1, dim> direction = t;
    if (std::abs(trial) >= largest)
      {
        support.tangential_force = std::copysign(largest, trial);
        if (largest > 0.)
          direction += std::copysign(friction_coefficient, trial) * n;
      }
    else
      {
        support.tangential_force = trial;
        equations.stiffness += spring * outer_product(t, t);
      }
    equations.force_operator = outer_product(t, direction);
    equations.residual += (t * force - support.tangential_force) * t;
  }



  const WallContact::NodeEquations *
  WallContact::equations_at(const unsigned int vertex_index) const
  {
    const unsigned int index = node_at_vertex[vertex_index];
    return index == numbers::invalid_unsigned_int ? nullptr :
                                                    &nodes[index].equations;
  }



  void
  WallContact::replace_residual(Vector &residual) const
  {
    for (const Node &node : nodes)
      if (node.is_owned)
        for (unsigned int d = 0; d < dim; ++d)
          residual[node.dofs[d]] = node.equations.residual[d];
  }



  unsigned int
  WallContact::update_contact()
  {
    unsigned int n_changes = 0;
    for (Node &node : nodes)
      {
        // Of two supports that pull, the one that pulls more goes first.
        Support *released = nullptr;
        for (Support &support : node.supports)
          if (support.is_active && !support.is_bilateral &&
              support.normal_force < -pull_tolerance * node.weight &&
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



  void
  WallContact::set_weight(const Vector &weight)
  {
    for (Node &node : nodes)
      node.weight = node_value(weight, node.dofs).norm();
  }



  void
  WallContact::commit()
  {
    for (Node &node : nodes)
      for (Support &support : node.supports)
        {
          support.was_active        = support.is_active;
          support.tangential_before = support.tangential_force;
        }
  }



  void
  WallContact::restore()
  {
    for (Node &node : nodes)
      for (Support &support : node.supports)
        support.is_active = support.was_active;
  }



  std::vector<WallForce>
  WallContact::wall_forces() const
  {
    std::vector<WallForce> forces;
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
} // namespace Sandglass
