#ifndef sandglass_flow_particle_in_cell_wall_impulse_h
#define sandglass_flow_particle_in_cell_wall_impulse_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <sandglass/continuum/formulation.h>

#include <array>

namespace Sandglass
{
  /// What a wall does within one step to a particle that it holds itself,
  /// where contact at the nodes does not.
  template <int dim>
  struct WallImpulse
  {
    std::array<dealii::Point<dim>, 2> ends;   ///< of the wall's face
    double                            place;  ///< from ends[0] (0) to [1] (1)
    dealii::Tensor<1, dim>            normal; ///< outward from the material
    /// On the particle, in N s (plane strain: per metre of depth).
    dealii::Tensor<1, dim> impulse;
    dealii::Tensor<1, dim> velocity; ///< of the particle afterwards, in m/s
  };
} // namespace Sandglass

#endif
