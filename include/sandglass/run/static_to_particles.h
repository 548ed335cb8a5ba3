#ifndef sandglass_run_static_to_particles_h
#define sandglass_run_static_to_particles_h

#include <sandglass/flow/particle_in_cell/particle_stage.h>
#include <sandglass/flow/updated_lagrangian/static_state.h>

namespace Sandglass
{
  /**
   * Carry the state at rest to the particles (paper, Section 4.4, step 1): each
   * takes the stress of its element (in quadrilaterals, of the nearest
   * quadrature point) and, if `displaces_particles`, moves by the element's
   * displacement on the undeformed grid. Collective.
   */
  void
  carry_to_particles(const StaticState &static_state,
                     ParticleStage     &stage,
                     const bool         displaces_particles);
} // namespace Sandglass

#endif
