#ifndef sandglass_particle_stage_random_nodal_field_h
#define sandglass_particle_stage_random_nodal_field_h

#include <sandglass/particle_stage/nodal_fields.h>
#include <sandglass/scene/scene.h>

namespace Sandglass
{
  /**
   * Fill the field with numbers between -1 and 1 that look random but depend
   * only on the node's position, so that each partition of the grid gives the
   * same field.
   */
  void
  fill_with_random_numbers(NodalField<dim> &field, const Scene &scene);
} // namespace Sandglass

#endif
