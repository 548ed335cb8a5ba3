#ifndef sandglass_flow_particle_in_cell_is_dense_h
#define sandglass_flow_particle_in_cell_is_dense_h

#include <sandglass/particles/particle_state.h>

namespace Sandglass
{
  /**
   * Whether particles resist compression: a particle without stress that is
   * less dense than `smallest_density` (in kg/m^3) is separated.
   */
  template <typename State>
  auto
  is_dense(const State &state, const double smallest_density)
  {
    using Number = decltype(state.density);
    return (state.density >= Number(smallest_density)) |
           (state.stress[Component::yy] != Number(0.));
  }
} // namespace Sandglass

#endif
