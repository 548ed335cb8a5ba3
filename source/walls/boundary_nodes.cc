#include <sandglass/choices.h>
#include <sandglass/choices.h>
#include <sandglass/walls/boundary_nodes.h>

#include <algorithm>
#include <map>

namespace Sandglass
{
  namespace
  {
    constexpr double same_direction = 1. - 1e-8;

    /// Outward normal of a straight boundary edge of `cell`.
    template <typename CellIterator>
    Tensor<1, 2>
    outward_normal(const CellIterator &cell, const unsigned int face_no)
    {
      const auto           face    = cell->face(face_no);
      const Tensor<1, 2>   tangent = face->vertex(1) - face->vertex(0);
      Tensor<1, 2>         normal{{tangent[1], -tangent[0]}};
      normal /= normal.norm();
      return normal * (face->center() - cell->center()) > 0. ? normal :
                                                               -1. * normal;
    }



    /// Integral of the edge's linear shape function of its end `own` over the
    /// edge's area.
    template <int dim>
    double
    tributary_area(const Point<dim> &own,
                   const Point<dim> &other,
                   const Formulation formulation)
    {
      return own.distance(other) / 2. *
             measure<dim>(formulation, Point<dim>((2. * own + other) / 3.));
    }



    template <int dim>
    void
    add_support(std::vector<NodeSupport<dim>> &supports, const NodeSupport<dim> &added)
    {
      for (auto &support : supports)
        if (support.normal * added.normal > same_direction &&
            (support.role == BoundaryRole::axis) ==
              (added.role == BoundaryRole::axis))
          {
            support.tributary_area += added.tributary_area;
            support.role = std::min(support.role, added.role);
            return;
          }
      supports.push_back(added);
    }



    template <int dim>
    bool
    has_role(const BoundaryNode<dim> &node, const BoundaryRole role)
    {
      return std::any_of(node.supports.begin(),
                         node.supports.end(),
                         [role](const NodeSupport<dim> &support) {
                           return support.role == role;
                         });
    }
  } // namespace



  template <int dim>
  std::vector<BoundaryNode<dim>>
  find_boundary_nodes(const DoFHandler<dim> &dof_handler,
                      const Formulation      formulation,
                      const WallParameters  &parameters)
  {
    std::map<types::global_dof_index, BoundaryNode<dim>> nodes;
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        if (cell->is_artificial())
          continue;
        for (const unsigned int face_no : cell->face_indices())
          {
            const auto face = cell->face(face_no);
            if (!face->at_boundary())
              continue;
            const auto role = static_cast<BoundaryRole>(face->boundary_id());
            for (const unsigned int v : {0u, 1u})
              {
                auto &node    = nodes[face->vertex_dof_index(v, 0)];
                node.dof      = face->vertex_dof_index(v, 0);
                node.position = face->vertex(v);
                if (role == BoundaryRole::fall_side)
                  node.is_outlet_lip = true;
                if (role == BoundaryRole::axis || is_wall(role))
                  add_support(node.supports,
                              {role,
                               outward_normal(cell, face_no),
                               tributary_area(face->vertex(v),
                                              face->vertex(1 - v),
                                              formulation)});
              }
          }
      }

    std::vector<BoundaryNode<dim>> result;
    for (auto &[dof, node] : nodes)
      {
        if (node.supports.empty())
          continue;
        node.is_free = node.is_outlet_lip &&
                       parameters.outlet_lip == WallParameters::OutletLip::free;
        node.is_fixed = parameters.fix_bottom_corner && !node.is_free &&
                        has_role(node, BoundaryRole::wall) &&
                        (has_role(node, BoundaryRole::floor) ||
                         has_role(node, BoundaryRole::outlet));
        result.push_back(node);
      }
    return result;
  }



#define INSTANTIATE(dim) \
  template std::vector<BoundaryNode<dim>> find_boundary_nodes<dim>(const DoFHandler<dim> &, const Formulation, const WallParameters &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
