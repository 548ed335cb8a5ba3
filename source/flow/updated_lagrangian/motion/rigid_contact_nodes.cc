#include <sandglass/flow/updated_lagrangian/motion/rigid_contact.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Sandglass
{
  namespace
  {
    /// In m, over a wall's length: rounding of places on it.
    constexpr double tolerance = 1e-9;

    /// A node whose contact has changed more often within a step stays on the
    /// wall to its end: otherwise Newton's method may run in circles.
    constexpr unsigned int most_changes = 6;

    /// Over the size of elements: what stands no deeper in a wall at the start
    /// of a step is brought back to it.
    constexpr double nearly_on = 1e-2;

    /// Walls whose directions differ by less are one to a corner.
    constexpr double smallest_sine = 1e-3;
  } // namespace



  RigidContact::RigidContact(
    const MovingGrid                              &grid,
    const std::vector<RigidWall>                  &walls,
    const double                                   constraint_scale,
    const double                                   tangential_penalty,
    const std::function<double(const Point<2> &)> &depth)
    : grid(grid)
    , walls(walls)
    , constraint_scale(constraint_scale)
    , tangential_penalty(tangential_penalty)
    , depth(depth)
    , node_at_dof(grid.elements.n_local_dofs(), numbers::invalid_unsigned_int)
  {
    for (const auto &[cell, edge, mark] : grid.mesh.boundary)
      for (const unsigned int n : grid.mesh.edge_nodes(cell, edge))
        {
          unsigned int &index = node_at_dof[grid.dof_of_node[n]];
          if (index == numbers::invalid_unsigned_int)
            {
              index = nodes.size();
              Node node;
              node.node     = n;
              node.dof      = grid.dof_of_node[n];
              node.position = node.position_before = grid.mesh.nodes[n];
              nodes.push_back(node);
            }
          Touches   &touches = nodes[index].touches;
          const bool is_known =
            std::any_of(touches.begin(), touches.end(), [mark = mark](auto &t) {
              return t.wall == mark;
            });
          if (mark == TriangleMesh::free_surface || is_known ||
              touches.size() == 2 ||
              (touches.size() == 1 && std::abs(walls[touches[0].wall].sine_to(
                                        walls[mark])) < smallest_sine))
            continue;
          Touch touch;
          touch.wall = mark;
          touches.push_back(touch);
        }
    find_areas();
    for (Node &node : nodes)
      node.touches_before = node.touches;
  }



  void
  RigidContact::find_areas()
  {
    std::vector<const Point<2> *> position(grid.mesh.nodes.size(), nullptr);
    for (const Node &node : nodes)
      position[node.node] = &node.position_before;
    faces_at.assign(nodes.size(), {});
    for (const auto &[cell, edge, mark] : grid.mesh.boundary)
      {
        const auto        &cell_nodes = grid.mesh.cells[cell];
        const unsigned int a = cell_nodes[edge], b = cell_nodes[(edge + 1) % 3];
        const Tensor<1, 2> along = *position[b] - *position[a];
        const Tensor<1, 2> area({along[1], -along[0]});
        const auto         add = [&](const unsigned int n, const double share) {
          faces_at[node_at_dof[grid.dof_of_node[n]]].push_back(
            share * depth(*position[n]) * area);
        };
        const bool is_quadratic = grid.mesh.order == 2;
        for (const unsigned int n : {a, b})
          add(n, is_quadratic ? 1. / 6. : 0.5);
        if (is_quadratic)
          add(cell_nodes[3 + edge], 4. / 6.);
      }
    for (Node &node : nodes)
      for (Touch &touch : node.touches)
        touch.area = area_at(node, touch.wall);
    spacing = std::numeric_limits<double>::max();
    for (const auto &[cell, edge, mark] : grid.mesh.boundary)
      spacing = std::min(spacing,
                         position[grid.mesh.cells[cell][edge]]->distance(
                           *position[grid.mesh.cells[cell][(edge + 1) % 3]]));
  }



  double
  RigidContact::area_at(const Node &node, const unsigned int wall) const
  {
    constexpr double smallest_cosine = 0.7;
    double           area            = 0.;
    for (const Tensor<1, 2> &face : faces_at[node_at_dof[node.dof]])
      if (face * walls[wall].normal > smallest_cosine * face.norm())
        area += face.norm();
    return area;
  }



  bool
  RigidContact::release(Node &node) const
  {
    Touch *released = nullptr;
    for (Touch &touch : node.touches)
      {
        const RigidWall &wall = walls[touch.wall];
        if (wall.is_axis())
          continue;
        if (!wall.reaches(node.position))
          {
            released = &touch;
            break;
          }
        if (touch.normal_force < -smallest_pull &&
            (!released || touch.normal_force < released->normal_force))
          released = &touch;
      }
    if (!released)
      return false;
    node.touches.erase(node.touches.begin() + (released - node.touches.data()));
    return true;
  }



  bool
  RigidContact::hold(Node &node) const
  {
    if (node.touches.size() == 2)
      return false;
    for (unsigned int w = 0; w < walls.size(); ++w)
      {
        const RigidWall &wall   = walls[w];
        const double     small  = tolerance * wall.length();
        const double     after  = wall.gap(node.position);
        const double     before = wall.gap(node.position_before);
        if (after <= small ||
            (!wall.is_axis() &&
             before > std::max(small, nearly_on * spacing)) ||
            (!node.touches.empty() &&
             (node.touches[0].wall == w ||
              std::abs(walls[node.touches[0].wall].sine_to(wall)) <
                smallest_sine)))
          continue;
        // Where its way has passed the wall's line.
        const double   share = before < 0. ? before / (before - after) : 0.;
        const Point<2> passage =
          node.position_before + share * (node.position - node.position_before);
        if (!wall.reaches(passage) || !wall.reaches(node.position))
          continue;
        Touch touch;
        touch.wall = w;
        touch.area = area_at(node, w);
        // A wall that has let go of a node in this step has its friction yet.
        for (const Touch &known : node.touches_before)
          if (known.wall == w)
            touch = known;
        node.touches.push_back(touch);
        return true;
      }
    return false;
  }



  unsigned int
  RigidContact::update_contact(const double)
  {
    unsigned int n_changes = 0;
    for (Node &node : nodes)
      {
        const bool may_release = node.n_changes < most_changes;
        if ((may_release && release(node)) || hold(node))
          {
            ++node.n_changes;
            ++n_changes;
          }
      }
    return n_changes;
  }
} // namespace Sandglass
