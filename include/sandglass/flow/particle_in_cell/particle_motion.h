#ifndef sandglass_flow_particle_in_cell_particle_motion_h
#define sandglass_flow_particle_in_cell_particle_motion_h

#include <sandglass/particles/particle_state.h>

namespace Sandglass
{
  /// Step 6 of Section 4.4: V_P += dt N(X_P) a.
  template <typename Vector, typename State>
  void
  accelerate(const Vector &acceleration, const double time_step, State &state)
  {
    for (unsigned int d = 0; d < State::dim; ++d)
      state.velocity[d] += time_step * acceleration[d];
  }

  /**
   * V_P += share (N(X_P) v^L - V_P), the share of PIC in the update of step 6.
   *
   * What of the particles' velocities the nodes don't see is kept for ever by
   * step 6, also where it doesn't move them. Light particles among heavy ones
   * gather most, and are thrown out as soon as they are alone.
   */
  template <typename Vector, typename State>
  void
  approach(const Vector &velocity, const double share, State &state)
  {
    for (unsigned int d = 0; d < State::dim; ++d)
      state.velocity[d] += share * (velocity[d] - state.velocity[d]);
  }

  /**
   * Step 9 of Section 4.4: X_P += dt N(X_P) v^L, and the coordinates of the new
   * position in the cell where the particle was.
   *
   * @param velocity  N(X_P) v^L, in m/s.
   */
  template <typename Vector, typename Shape, typename State>
  void
  move(const Vector &velocity,
       const double  time_step,
       const Shape  &shape,
       State        &state)
  {
    for (unsigned int d = 0; d < State::dim; ++d)
      state.location[d] += time_step * velocity[d];
    state.reference = shape.to_reference(state.location, state.reference);
  }
} // namespace Sandglass

#endif
