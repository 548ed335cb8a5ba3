#ifndef sandglass_particle_stage_particle_motion_h
#define sandglass_particle_stage_particle_motion_h

#include <sandglass/particles/particle_state.h>

namespace Sandglass
{
  /// Step 6 of Section 4.4: V_P += dt N(X_P) a.
  template <typename Number>
  void
  accelerate(const Pair<Number>    &acceleration,
             const double           time_step,
             ParticleState<Number> &state)
  {
    for (unsigned int d = 0; d < dim; ++d)
      state.velocity[d] += time_step * acceleration[d];
  }

  /**
   * Step 9 of Section 4.4: X_P += dt N(X_P) v^L, and the coordinates of the new
   * position in the cell where the particle was.
   *
   * @param velocity  N(X_P) v^L, in m/s.
   */
  template <typename Number, typename Shape>
  void
  move(const Pair<Number>    &velocity,
       const double           time_step,
       const Shape           &shape,
       ParticleState<Number> &state)
  {
    for (unsigned int d = 0; d < dim; ++d)
      state.location[d] += time_step * velocity[d];
    state.reference = shape.to_reference(state.location, state.reference);
  }
} // namespace Sandglass

#endif
