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

    Tensor<1, 2>
    value_at(const DisplacementVector &vector, const unsigned int dof)
    {
      return Tensor<1, 2>(
        {vector.local_element(dof), vector.local_element(dof + 1)});
    }



    double
    sine_between(const RigidWall &a, const RigidWall &b)
    {
      return a.normal[0] * b.normal[1] - a.normal[1] * b.normal[0];
    }



    /// Where the lines of two walls cross.
    Point<2>
    crossing(const RigidWall &a, const RigidWall &b)
    {
      const double offset_a = a.normal * a.start, offset_b = b.normal * b.start;
      const double sine = sine_between(a, b);
      return Point<2>((offset_a * b.normal[1] - offset_b * a.normal[1]) / sine,
                      (offset_b * a.normal[0] - offset_a * b.normal[0]) / sine);
    }
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
              (touches.size() == 1 &&
               std::abs(sine_between(walls[touches[0].wall], walls[mark])) <
                 smallest_sine))
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



  void
  RigidContact::evaluate(const Vector &force,
                         const Vector &displacement,
                         const Vector &increment)
  {
    for (Node &node : nodes)
      {
        node.position =
          grid.straight[node.node] + value_at(displacement, node.dof);
        const Tensor<1, 2> f = value_at(force, node.dof);
        node.equations       = NodeEquations();
        if (node.touches.size() == 2)
          evaluate_corner(node, f);
        else if (node.touches.size() == 1)
          evaluate_sliding(node, f, value_at(increment, node.dof));
        else
          {
            node.equations.force_operator = unit_symmetric_tensor<2>();
            node.equations.residual       = f;
          }
      }
  }



  void
  RigidContact::evaluate_sliding(Node               &node,
                                 const Tensor<1, 2> &force,
                                 const Tensor<1, 2> &increment)
  {
    Touch           &touch     = node.touches[0];
    const RigidWall &wall      = walls[touch.wall];
    NodeEquations   &equations = node.equations;

    touch.normal_force = -(wall.normal * force);
    equations.stiffness =
      constraint_scale * outer_product(wall.normal, wall.normal);
    equations.residual =
      constraint_scale * wall.gap(node.position) * wall.normal;

    const double mu     = wall.friction_coefficient;
    const double limit  = mu * std::max(touch.normal_force, 0.);
    const double spring = tangential_penalty * touch.area;
    const double trial =
      touch.tangential_before - spring * (wall.tangent * increment);
    const Tensor<2, 2> along = outer_product(wall.tangent, wall.tangent);

    equations.force_operator = along;
    touch.is_sliding         = std::abs(trial) >= limit;
    touch.tangential_force =
      touch.is_sliding ? std::copysign(limit, trial) : trial;
    touch.dissipation = touch.is_sliding && spring > 0. ?
                          limit * (std::abs(trial) - limit) / spring :
                          0.;
    if (!touch.is_sliding)
      equations.stiffness += spring * along;
    else if (limit > 0.)
      equations.force_operator +=
        std::copysign(mu, trial) * outer_product(wall.tangent, wall.normal);
    equations.residual +=
      (wall.tangent * force - touch.tangential_force) * wall.tangent;
  }



  void
  RigidContact::evaluate_corner(Node &node, const Tensor<1, 2> &force)
  {
    const RigidWall &a = walls[node.touches[0].wall];
    const RigidWall &b = walls[node.touches[1].wall];
    node.equations.stiffness =
      constraint_scale * Tensor<2, 2>(unit_symmetric_tensor<2>());
    node.equations.residual =
      constraint_scale * (node.position - crossing(a, b));
    // -force = F_a n_a + F_b n_b
    const double sine = sine_between(a, b);
    node.touches[0].normal_force =
      -(force[0] * b.normal[1] - force[1] * b.normal[0]) / sine;
    node.touches[1].normal_force =
      -(a.normal[0] * force[1] - a.normal[1] * force[0]) / sine;
    for (Touch &touch : node.touches)
      {
        touch.tangential_force = touch.dissipation = 0.;
        touch.is_sliding                           = false;
      }
  }



  const RigidContact::NodeEquations *
  RigidContact::equations_at(const unsigned int local_dof) const
  {
    const unsigned int index = node_at_dof[local_dof];
    return index == numbers::invalid_unsigned_int ||
               nodes[index].touches.empty() ?
             nullptr :
             &nodes[index].equations;
  }



  void
  RigidContact::replace_residual(Vector &residual) const
  {
    for (const Node &node : nodes)
      for (unsigned int d = 0; d < 2; ++d)
        residual.local_element(node.dof + d) = node.equations.residual[d];
  }



  void
  RigidContact::add_stiffness(TangentMatrix<2> &matrix) const
  {
    for (const Node &node : nodes)
      if (!node.touches.empty())
        for (unsigned int i = 0; i < 2; ++i)
          for (unsigned int j = 0; j < 2; ++j)
            matrix.add(node.dof + i,
                       node.dof + j,
                       node.equations.stiffness[i][j]);
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
              std::abs(sine_between(walls[node.touches[0].wall], wall)) <
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



  void
  RigidContact::commit()
  {
    for (Node &node : nodes)
      {
        node.position_before = node.position;
        node.n_changes       = 0;
        for (Touch &touch : node.touches)
          touch.tangential_before = touch.tangential_force;
      }
    find_areas();
    for (Node &node : nodes)
      node.touches_before = node.touches;
  }



  void
  RigidContact::restore()
  {
    for (Node &node : nodes)
      {
        node.touches   = node.touches_before;
        node.n_changes = 0;
      }
  }



  void
  RigidContact::correct_motion(Vector &velocity, Vector &acceleration) const
  {
    for (const Node &node : nodes)
      for (Vector *vector : {&velocity, &acceleration})
        {
          Tensor<1, 2> value = value_at(*vector, node.dof);
          if (node.touches.size() == 2)
            value = 0.;
          else if (node.touches.size() == 1)
            {
              const Tensor<1, 2> &n = walls[node.touches[0].wall].normal;
              value -= (value * n) * n;
            }
          for (unsigned int d = 0; d < 2; ++d)
            vector->local_element(node.dof + d) = value[d];
        }
  }



  std::vector<NodeContact>
  RigidContact::contacts() const
  {
    std::vector<NodeContact> result;
    for (const Node &node : nodes)
      for (const Touch &touch : node.touches_before)
        result.push_back({node.node,
                          touch.wall,
                          node.position_before,
                          touch.area,
                          touch.normal_force,
                          touch.tangential_force,
                          touch.is_sliding,
                          touch.dissipation});
    return result;
  }



  void
  RigidContact::set_tangential_traction(
    const std::function<double(const unsigned int, const Point<2> &)> &traction)
  {
    for (Node &node : nodes)
      {
        for (Touch &touch : node.touches)
          touch.tangential_before = touch.tangential_force =
            touch.area * traction(touch.wall, node.position_before);
        node.touches_before = node.touches;
      }
  }
} // namespace Sandglass
