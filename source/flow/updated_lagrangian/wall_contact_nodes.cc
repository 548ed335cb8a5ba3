#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/updated_lagrangian/wall_contact.h>
#include <sandglass/walls/corner.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Sandglass
{
  namespace
  {
    /// Material on the axis can't leave it: there a wall acts along it only. In
    /// space it acts along the symmetry planes.
    template <int dim>
    void
    align_with_axis(Supports<dim> &supports)
    {
      if constexpr (dim == 3)
        {
          SupportSet planes = 0;
          for (unsigned int s = 0; s < supports.size(); ++s)
            if (supports[s].is_axis)
              planes |= 1u << s;
          const HeldDirections<dim> held(supports, planes);
          for (auto &support : supports)
            if (planes != 0 && !support.is_axis)
              {
                const Tensor<1, dim> along = held.left_of(support.normal);
                if (along.norm() > 1e-8)
                  support.normal = along / along.norm();
              }
          return;
        }
      const bool has_axis =
        std::any_of(supports.begin(), supports.end(), [](const auto &support) {
          return support.is_axis;
        });
      for (auto &support : supports)
        if (has_axis && !support.is_axis)
          {
            const double up   = std::copysign(1., support.normal[1]);
            support.normal    = Tensor<1, dim>();
            support.normal[1] = up;
          }
    }

    /// Of the nodes in the middle of edges at the boundary, the edges' ends.
    template <int dim>
    std::map<types::global_dof_index, std::array<unsigned int, 2>>
    find_ends_of_edges(const DoFHandler<dim> &node_handler)
    {
      std::map<types::global_dof_index, std::array<unsigned int, 2>> ends;
      if (node_handler.get_fe().degree == 2)
        for (const auto &cell : node_handler.active_cell_iterators())
          if (!cell->is_artificial())
            for (const auto &face : cell->face_iterators())
              if (face->at_boundary())
                ends[face->dof_index(0)] = {
                  {face->vertex_index(0), face->vertex_index(1)}};
      return ends;
    }
  } // namespace



  template <int dim>
  WallContact<dim>::WallContact(const FilledGrid<dim> &grid,
                                const Scene<dim>      &scene,
                                const WallParameters  &parameters,
                                const Vector          &weight,
                                const double           constraint_scale)
    : communicator(grid.triangulation.get_communicator())
    , tangential_penalty(parameters.tangential_penalty)
    , constraint_scale(constraint_scale)
    , node_at_dof(grid.n_local_dofs(), numbers::invalid_unsigned_int)
  {
    find_dofs(grid, collect_nodes(grid, scene, parameters));
    const bool has_weight_at_vertices = grid.finite_element.degree == 1;
    for (Node &node : nodes)
      {
        for (unsigned int d = 0; d < dim; ++d)
          node.weight[d] = weight[node.dofs[d]];
        if (has_weight_at_vertices)
          open_supports(node);
      }
  }



  template <int dim>
  std::map<types::global_dof_index, unsigned int>
  WallContact<dim>::collect_nodes(const FilledGrid<dim> &grid,
                                  const Scene<dim>      &scene,
                                  const WallParameters  &parameters)
  {
    std::map<types::global_dof_index, unsigned int> index_of;
    const auto ends_of_edge = find_ends_of_edges(grid.node_handler);
    for (BoundaryNode<dim> &found : find_boundary_nodes(
           grid.node_handler, scene.formulation, scene.walls, parameters))
      {
        align_with_axis<dim>(found.supports);
        index_of[found.dof] = nodes.size();
        Node       node;
        const auto ends =
          found.vertex == numbers::invalid_unsigned_int ?
            ends_of_edge.at(found.dof) :
            std::array<unsigned int, 2>{{found.vertex, found.vertex}};
        for (unsigned int v = 0; v < 2; ++v)
          node.vertices[v] = grid.scene_vertices[ends[v]];
        node.supports = found.supports;
        for (unsigned int s = 0; s < found.supports.size(); ++s)
          node.states[s].is_bilateral =
            found.is_fixed || found.supports[s].is_axis;
        nodes.push_back(node);
      }
    return index_of;
  }



  template <int dim>
  void
  WallContact<dim>::find_dofs(
    const FilledGrid<dim>                                 &grid,
    const std::map<types::global_dof_index, unsigned int> &index_of)
  {
    std::vector<types::global_dof_index> scalar_dofs(
      grid.node_handler.get_fe().n_dofs_per_cell()),
      dofs(grid.finite_element.n_dofs_per_cell());
    for (const auto &local_cell : grid.local_cells)
      {
        local_cell.cell->get_dof_indices(dofs);
        typename DoFHandler<dim>::active_cell_iterator(&grid.triangulation,
                                                       local_cell.cell->level(),
                                                       local_cell.cell->index(),
                                                       &grid.node_handler)
          ->get_dof_indices(scalar_dofs);
        for (unsigned int i = 0; i < scalar_dofs.size(); ++i)
          {
            const auto found = index_of.find(scalar_dofs[i]);
            if (found == index_of.end())
              continue;
            node_at_dof[local_cell.dofs[dim * i]] = found->second;
            Node &node                            = nodes[found->second];
            for (unsigned int d = 0; d < dim; ++d)
              node.dofs[d] = dofs[dim * i + d];
            node.is_owned = grid.owned_dofs.is_element(node.dofs[0]);
          }
      }
  }



  template <int dim>
  void
  WallContact<dim>::open_supports(Node &node) const
  {
    // As a share of the weight; a vertical wall's normal is exact to rounding.
    constexpr double smallest_pull = 1e-3;

    const auto carried_by = [&node](const unsigned int s) {
      return node.supports[s].normal * node.weight;
    };
    const unsigned int n            = node.supports.size();
    unsigned int       carrier      = 0;
    bool               is_bilateral = false;
    for (unsigned int s = 0; s < n; ++s)
      {
        is_bilateral = is_bilateral || node.states[s].is_bilateral;
        if (carried_by(s) >= carried_by(carrier))
          carrier = s;
      }
    for (unsigned int s = 0; s < n; ++s)
      if (!node.states[s].is_bilateral)
        node.states[s].is_active = node.states[s].was_active =
          (is_bilateral || s == carrier) &&
          carried_by(s) >= -smallest_pull * node.weight.norm();
  }



#define INSTANTIATE(dim)                                             \
  template WallContact<dim>::WallContact(const FilledGrid<dim> &,    \
                                         const Scene<dim> &,         \
                                         const WallParameters &,     \
                                         const DisplacementVector &, \
                                         const double);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
