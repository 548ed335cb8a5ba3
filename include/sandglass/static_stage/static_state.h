#ifndef sandglass_static_stage_static_state_h
#define sandglass_static_stage_static_state_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <sandglass/base/setting.h>
#include <sandglass/material/stress.h>
#include <sandglass/walls/wall_force.h>

#include <array>
#include <vector>

namespace Sandglass
{
  /**
   * The state at rest, as far as this rank's cells go. Entry i of the vectors
   * belongs to active cell i of the Scene; entries of cells that aren't filled
   * or not owned are meaningless.
   */
  struct StaticState
  {
    struct CellState
    {
      /// At the cell's nodes, in deal.II's vertex order, in m.
      std::array<dealii::Tensor<1, dim>, 4> displacement;
      /// At the cell's quadrature points (one per triangle, four per
      /// quadrilateral in deal.II's order), in Pa.
      std::array<SymmetricTensor4, 4> stress;
      /// Current over initial volume, at the same points.
      std::array<double, 4> volume_ratio;
    };

    std::vector<CellState> cells;

    /// Of the nodes that this rank owns.
    std::vector<WallForce> wall_forces;

    /// What it took to find the state, on all ranks together.
    struct Effort
    {
      unsigned int n_unknowns          = 0;
      bool         is_direct           = true; ///< by factors, not multigrid
      unsigned int n_newton_iterations = 0;
      unsigned int n_linear_iterations = 0;
    };
    Effort effort;
  };
} // namespace Sandglass

#endif
