#ifndef sandglass_flow_updated_lagrangian_static_state_h
#define sandglass_flow_updated_lagrangian_static_state_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <sandglass/continuum/symmetric_components.h>
#include <sandglass/walls/wall_force.h>

#include <array>
#include <vector>

namespace Sandglass
{
  /// What it took to find the state at rest, on all ranks together.
  struct StaticEffort
  {
    unsigned int n_unknowns          = 0;
    bool         is_direct           = true; ///< by factors, not multigrid
    unsigned int n_newton_iterations = 0;
    unsigned int n_linear_iterations = 0;
    unsigned int n_relaxation_steps  = 0;
  };

  /**
   * The state at rest, as far as this rank's cells go. Entry i of the vectors
   * belongs to active cell i of the Scene; entries of cells that aren't filled
   * or not owned are meaningless.
   */
  template <int dim>
  struct StaticState
  {
    /// Of a cube; a simplex uses fewer.
    static constexpr unsigned int n_vertices = 1u << dim;

    /// Of a quadratic triangle or a hexahedron; other cells use fewer.
    static constexpr unsigned int most_nodes = dim == 2 ? 6 : n_vertices;

    struct CellState
    {
      /// At the cell's nodes, in deal.II's order, in m.
      std::array<dealii::Tensor<1, dim>, most_nodes> displacement;
      /// At the cell's quadrature points (one per triangle or tetrahedron, four
      /// per quadrilateral and eight per hexahedron in deal.II's order, three
      /// per quadratic triangle), in Pa.
      std::array<SymmetricComponents<2 * dim>, n_vertices> stress;
      /// Current over initial volume, at the same points.
      std::array<double, n_vertices> volume_ratio;
      /// The law's state variables, likewise.
      std::array<std::vector<double>, n_vertices> law_state;
    };

    /// Of the elements.
    unsigned int element_order = 1;

    std::vector<CellState> cells;

    /// Wall forces on the nodes that this rank owns.
    std::vector<WallForce<dim>> wall_forces;

    StaticEffort effort;
  };
} // namespace Sandglass

#endif
