#ifndef sandglass_flow_particle_in_cell_wall_impulse_h
#define sandglass_flow_particle_in_cell_wall_impulse_h

#include <deal.II/base/tensor.h>

#include <array>

namespace Sandglass
{
  /// What a wall does within one step to a particle that it holds itself,
  /// where contact at the nodes does not.
  template <int dim>
  struct WallImpulse
  {
    /// A boundary face of the scene's grid: its cell, and its number in it.
    unsigned int cell, face;
    /// Linear shape functions of the cell's vertices at the place on the face.
    std::array<double, 1u << dim> shape_values;
    /// On the particle, in N s (plane strain: per metre of depth).
    dealii::Tensor<1, dim> impulse;
    /// Of the particle afterwards, relative to the wall's, in m/s.
    dealii::Tensor<1, dim> slip;
    dealii::Tensor<1, dim> wall_velocity; ///< in m/s
  };
} // namespace Sandglass

#endif
