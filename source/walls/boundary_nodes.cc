#include <sandglass/base/exceptions.h>
#include <sandglass/choices/choose_kinematics.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/walls/boundary_nodes.h>
#include <sandglass/walls/face_geometry.h>
#include <sandglass/walls/facets.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace Sandglass
{
  namespace
  {
    /// A node of a face, with the integral of its shape function over the
    /// face's area.
    template <int dim>
    struct FaceNode
    {
      types::global_dof_index dof;
      unsigned int            vertex; ///< invalid in the middle of an edge
      Point<dim>              position;
      double                  area;
    };



    /// With linear shape functions.
    template <typename FaceIterator>
    double
    tributary_area(const FaceIterator &face,
                   const unsigned int  vertex,
                   const Formulation   formulation)
    {
      constexpr int  dim       = FaceIterator::AccessorType::space_dimension;
      const double   n         = face->n_vertices();
      Tensor<1, dim> positions = face->vertex(vertex);
      for (const unsigned int v : face->vertex_indices())
        positions += face->vertex(v);
      return face->measure() / n *
             measure<dim>(formulation, Point<dim>(positions / (n + 1.)));
    }



    template <typename FaceIterator>
    auto
    nodes_of(const FaceIterator &face,
             const unsigned int  degree,
             const Formulation   formulation)
    {
      constexpr int dim = FaceIterator::AccessorType::space_dimension;
      Assert(degree == 1 || (degree == 2 && dim == 2), ExcNotImplemented());
      std::vector<FaceNode<dim>> nodes;
      for (const unsigned int v : face->vertex_indices())
        nodes.push_back({face->vertex_dof_index(v, 0),
                         face->vertex_index(v),
                         face->vertex(v),
                         tributary_area(face, v, formulation)});
      if (degree == 1)
        return nodes;
      // Simpson's rule, exact here
      const Point<dim> center = face->center();
      for (FaceNode<dim> &node : nodes)
        node.area =
          face->measure() / 6. * measure<dim>(formulation, node.position);
      nodes.push_back(
        {face->dof_index(0),
         numbers::invalid_unsigned_int,
         center,
         face->measure() * 4. / 6. * measure<dim>(formulation, center)});
      return nodes;
    }



    template <int dim>
    [[noreturn]] void
    refuse(const Point<dim> &position, const std::string &what)
    {
      std::ostringstream message;
      message << "The mesh's boundary has more than " << what << " at ("
              << position << ") m. Allowed are meshes whose cells around a "
              << "vertex of the boundary are connected by faces.";
      throw InputError(message.str());
    }



    template <int dim>
    Support<dim> &
    find_support(BoundaryNode<dim>    &node,
                 const Tensor<1, dim> &normal,
                 const bool            is_axis)
    {
      for (auto &support : node.supports)
        if (support.normal * normal > same_direction &&
            support.is_axis == is_axis)
          return support;
      if (node.supports.size() == dim)
        refuse(node.position, std::to_string(dim) + " directions");
      Support<dim> support;
      support.normal  = normal;
      support.is_axis = is_axis;
      node.supports.push_back(support);
      return node.supports.back();
    }



    template <int dim>
    WallShare &
    find_share(BoundaryNode<dim> &node,
               Support<dim>      &support,
               const WallId       wall)
    {
      for (auto &share : support.walls)
        if (share.wall == wall)
          return share;
      if (support.walls.size() == Support<dim>::most_walls)
        refuse(node.position,
               std::to_string(Support<dim>::most_walls) + " walls in a plane");
      support.walls.push_back({wall, 0., 0., 0.});
      return support.walls.back();
    }



    /**
     * A closed outlet belongs to the wall beside it in the same plane, so the
     * nodes on its edge are this wall's. If it has a friction or motion of its
     * own, both keep their shares.
     */
    template <int dim>
    void
    merge_closed_outlet(Support<dim>                 &support,
                        const std::vector<Wall<dim>> &walls)
    {
      const auto is_outlet = [&walls](const WallShare &share) {
        return walls[share.wall].role == BoundaryRole::outlet;
      };
      const auto begin = support.walls.begin(), end = support.walls.end();
      const auto outlet = std::find_if(begin, end, is_outlet);
      const auto beside = std::find_if_not(begin, end, is_outlet);
      if (outlet == end || beside == end)
        return;
      const Wall<dim> &gate = walls[outlet->wall], &wall = walls[beside->wall];
      if (gate.friction_coefficient != wall.friction_coefficient ||
          gate.velocity != wall.velocity)
        return;
      beside->area += outlet->area;
      support.walls.erase(outlet);
    }



    /// The supports that the faces at a node make.
    template <int dim>
    void
    find_supports(BoundaryNode<dim> &node, Facets<dim> &facets)
    {
      if constexpr (dim == 3)
        unite_directions(facets);
      for (const Facet<dim> &facet : facets)
        {
          const bool is_axis = facet.wall == no_wall;
          auto      &support = find_support(node, facet.normal, is_axis);
          if (is_axis)
            support.area += facet.area;
          else
            find_share(node, support, facet.wall).area += facet.area;
        }
    }



    /// From the walls' areas, what they have of the support together.
    template <int dim>
    void
    share_out(Support<dim> &support, const std::vector<Wall<dim>> &walls)
    {
      if (support.is_axis)
        return;
      double friction = 0.;
      for (const WallShare &share : support.walls)
        {
          support.area += share.area;
          friction += walls[share.wall].friction_coefficient * share.area;
        }
      // Differences from one wall's values, so that means of equal values are
      // just these.
      const Wall<dim> &first       = walls[support.walls[0].wall];
      support.friction_coefficient = first.friction_coefficient;
      support.velocity             = first.velocity;
      for (WallShare &share : support.walls)
        {
          const Wall<dim> &wall = walls[share.wall];
          // A quadratic element's vertex on the axis has no area.
          share.of_normal_force = support.area > 0. ?
                                    share.area / support.area :
                                    1. / support.walls.size();
          share.of_friction =
            friction > 0. ? wall.friction_coefficient * share.area / friction :
                            share.of_normal_force;
          support.friction_coefficient +=
            share.of_normal_force *
            (wall.friction_coefficient - first.friction_coefficient);
          support.velocity +=
            share.of_friction * (wall.velocity - first.velocity);
        }
      support.velocity = support.tangential(support.velocity);
    }



    template <int dim>
    bool
    has_wall(const BoundaryNode<dim> &node)
    {
      return std::any_of(node.supports.begin(),
                         node.supports.end(),
                         [](const Support<dim> &support) {
                           return !support.is_axis;
                         });
    }



    template <int dim>
    bool
    has_role(const BoundaryNode<dim>      &node,
             const std::vector<Wall<dim>> &walls,
             const BoundaryRole            role)
    {
      for (const auto &support : node.supports)
        for (const WallShare &share : support.walls)
          if (walls[share.wall].role == role)
            return true;
      return false;
    }
  } // namespace



  template <int dim>
  std::vector<BoundaryNode<dim>>
  find_boundary_nodes(const DoFHandler<dim>        &dof_handler,
                      const Formulation             formulation,
                      const std::vector<Wall<dim>> &walls,
                      const WallParameters         &parameters)
  {
    std::map<types::global_dof_index, BoundaryNode<dim>> nodes;
    std::map<types::global_dof_index, Facets<dim>>       facets;
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        if (cell->is_artificial())
          continue;
        for (const unsigned int face_no : cell->face_indices())
          {
            const auto face = cell->face(face_no);
            if (!face->at_boundary())
              continue;
            const BoundaryPart part = boundary_part(walls, face->boundary_id());
            const bool         is_axis = part.role == BoundaryRole::axis;
            for (const FaceNode<dim> &of_face :
                 nodes_of(face, dof_handler.get_fe().degree, formulation))
              {
                auto &node    = nodes[of_face.dof];
                node.dof      = of_face.dof;
                node.vertex   = of_face.vertex;
                node.position = of_face.position;
                if (is_open(part.role))
                  node.is_outlet_lip = true;
                if (!is_axis && part.wall == no_wall)
                  continue;
                facets[of_face.dof].push_back({outward_normal(cell, face_no),
                                               is_axis ? no_wall : part.wall,
                                               of_face.area});
              }
          }
      }

    std::vector<BoundaryNode<dim>> result;
    for (auto &[dof, node] : nodes)
      {
        find_supports(node, facets[dof]);
        if (node.supports.empty())
          continue;
        for (auto &support : node.supports)
          {
            merge_closed_outlet(support, walls);
            share_out(support, walls);
          }
        // Where a wall ends at the open part of the boundary.
        node.is_outlet_lip = node.is_outlet_lip && has_wall(node);
        node.is_free       = node.is_outlet_lip &&
                       parameters.outlet_lip == WallParameters::OutletLip::free;
        node.is_fixed = parameters.fix_bottom_corner && !node.is_free &&
                        has_role(node, walls, BoundaryRole::wall) &&
                        (has_role(node, walls, BoundaryRole::floor) ||
                         has_role(node, walls, BoundaryRole::outlet));
        result.push_back(node);
      }
    return result;
  }



#define INSTANTIATE(dim)                                            \
  template std::vector<BoundaryNode<dim>> find_boundary_nodes<dim>( \
    const DoFHandler<dim> &,                                        \
    const Formulation,                                              \
    const std::vector<Wall<dim>> &,                                 \
    const WallParameters &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
