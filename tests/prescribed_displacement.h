#ifndef sandglass_tests_prescribed_displacement_h
#define sandglass_tests_prescribed_displacement_h

#include <sandglass/flow/updated_lagrangian/node_constraints.h>

#include <array>
#include <vector>

/// Nodes that are held, in one direction or in both, and those of the
/// footing, which are pressed down. On one rank.
class PrescribedDisplacement : public Sandglass::NodeConstraints<2>
{
public:
  /// @param stiffness  by which displacements are multiplied, in N/m.
  PrescribedDisplacement(const Sandglass::ElementGrid<2> &grid,
                         const double                     stiffness)
    : stiffness(stiffness)
    , nodes(grid.n_local_dofs())
  {}

  void
  hold(const unsigned int dof, const unsigned int direction)
  {
    nodes[dof].is_held[direction] = true;
  }

  void
  press(const unsigned int dof)
  {
    hold(dof, 1);
    nodes[dof].is_pressed = true;
  }

  double settlement = 0.; ///< of the footing since the start, in m

  /// Of the footing on the material, at the last evaluate(), in N per metre.
  double
  load() const
  {
    return footing_load;
  }

  void
  evaluate(const Vector &force,
           const Vector &displacement,
           const Vector & /*increment*/) override
  {
    footing_load = 0.;
    for (unsigned int dof = 0; dof < nodes.size(); dof += 2)
      {
        Node &node     = nodes[dof];
        node.equations = NodeEquations();
        for (unsigned int d = 0; d < 2; ++d)
          if (node.is_held[d])
            {
              const double goal = node.is_pressed && d == 1 ? -settlement : 0.;
              node.equations.stiffness[d][d] = stiffness;
              node.equations.residual[d] =
                stiffness * (displacement[dof + d] - goal);
            }
          else
            {
              node.equations.force_operator[d][d] = 1.;
              node.equations.residual[d]          = force[dof + d];
            }
        if (node.is_pressed)
          footing_load -= force[dof + 1];
      }
  }

  const NodeEquations *
  equations_at(const unsigned int dof) const override
  {
    return &nodes[dof].equations;
  }

  void
  replace_residual(Vector &residual) const override
  {
    for (unsigned int dof = 0; dof < nodes.size(); dof += 2)
      for (unsigned int d = 0; d < 2; ++d)
        residual[dof + d] = nodes[dof].equations.residual[d];
  }

  void
  add_stiffness(Sandglass::TangentMatrix<2> &matrix) const override
  {
    for (unsigned int dof = 0; dof < nodes.size(); dof += 2)
      for (unsigned int d = 0; d < 2; ++d)
        matrix.add(dof + d, dof + d, nodes[dof].equations.stiffness[d][d]);
  }

private:
  struct Node
  {
    std::array<bool, 2> is_held{};
    bool                is_pressed = false;
    NodeEquations       equations;
  };

  const double      stiffness;
  std::vector<Node> nodes; ///< by their first degree of freedom
  double            footing_load = 0.;
};

#endif
