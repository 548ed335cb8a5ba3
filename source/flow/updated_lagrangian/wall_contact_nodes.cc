#include <sandglass/choices.h>
#include <sandglass/flow/updated_lagrangian/wall_contact.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Sandglass
{
  namespace
  {
    /// Material on the axis can't leave it: there a wall acts along it only.
    template <int dim>
    void
    align_with_axis(std::vector<NodeSupport<dim>> &supports)
    {
      const bool has_axis =
        std::any_of(supports.begin(), supports.end(), [](const auto &support) {
          return support.role == BoundaryRole::axis;
        });
      for (auto &support : supports)
        if (has_axis && support.role != BoundaryRole::axis)
          support.normal =
            Tensor<1, dim>({0., std::copysign(1., support.normal[1])});
    }
  } // namespace



  template <int dim>
  WallContact<dim>::WallContact(const FilledGrid<dim>     &grid,
                           const Formulation     formulation,
                           const WallParameters &parameters,
                           const Vector         &weight,
                           const double          constraint_scale)
    : communicator(grid.triangulation.get_communicator())
    , friction_coefficient(parameters.friction_coefficient())
    , tangential_penalty(parameters.tangential_penalty)
    , constraint_scale(constraint_scale)
    , node_at_vertex(grid.triangulation.n_vertices(),
                     numbers::invalid_unsigned_int)
  {
    collect_nodes(grid, formulation, parameters);
    for (Node &node : nodes)
      {
        for (unsigned int d = 0; d < dim; ++d)
          node.weight[d] = weight[node.dofs[d]];
        open_upper_support(node);
      }
  }



  template <int dim>
  void
  WallContact<dim>::collect_nodes(const FilledGrid<dim>     &grid,
                             const Formulation     formulation,
                             const WallParameters &parameters)
  {
    std::map<types::global_dof_index, unsigned int> index_of;
    for (BoundaryNode<dim> &found :
         find_boundary_nodes(grid.node_handler, formulation, parameters))
      {
        align_with_axis(found.supports);
        index_of[found.dof] = nodes.size();
        Node node;
        node.position = found.position;
        for (const NodeSupport<dim> &support : found.supports)
          node.supports.push_back(
            {support.role,
             support.normal,
             wall_tangent(support.normal),
             support.tributary_area,
             found.is_fixed || support.role == BoundaryRole::axis});
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



  template <int dim>
  void
  WallContact<dim>::open_upper_support(Node &node) const
  {
    if (node.supports.size() < 2 || std::any_of(node.supports.begin(),
                                                node.supports.end(),
                                                [](const Support &support) {
                                                  return support.is_bilateral;
                                                }))
      return;
    auto &upper     = *std::min_element(node.supports.begin(),
                                    node.supports.end(),
                                    [&node](const auto &a, const auto &b) {
                                      return a.normal * node.weight <
                                             b.normal * node.weight;
                                    });
    upper.is_active = upper.was_active = false;
  }



#define INSTANTIATE(dim) \
  template class WallContact<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
