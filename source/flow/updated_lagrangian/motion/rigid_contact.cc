#include <sandglass/flow/updated_lagrangian/motion/rigid_contact.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Sandglass
{
  namespace
  {
    Tensor<1, 2>
    value_at(const DisplacementVector &vector, const unsigned int dof)
    {
      return Tensor<1, 2>(
        {vector.local_element(dof), vector.local_element(dof + 1)});
    }



    /// Where the lines of two walls cross.
    Point<2>
    crossing(const RigidWall &a, const RigidWall &b)
    {
      const double offset_a = a.normal * a.start, offset_b = b.normal * b.start;
      const double sine = a.sine_to(b);
      return Point<2>((offset_a * b.normal[1] - offset_b * a.normal[1]) / sine,
                      (offset_b * a.normal[0] - offset_a * b.normal[0]) / sine);
    }
  } // namespace



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
    const double sine = a.sine_to(b);
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
