#ifndef sandglass_run_static_to_particles_h
#define sandglass_run_static_to_particles_h

#include <sandglass/flow/dynamic_flow.h>
#include <sandglass/flow/updated_lagrangian/static_state.h>
#include <sandglass/scene/scene.h>

namespace Sandglass
{
  /**
   * Carry the state at rest to a flow's material (paper, Section 4.4, step 1):
   * it takes the stress and the law's state of its element (in quadrilaterals,
   * of the nearest quadrature point) and, if `displaces_particles`, moves by
   * the element's displacement on the undeformed grid. Collective.
   */
  template <int dim>
  void
  carry_to_particles(const StaticState<dim> &static_state,
                     const Scene<dim>       &scene,
                     DynamicFlow<dim>       &flow,
                     const bool              displaces_particles);
} // namespace Sandglass

#endif
