#ifndef sandglass_flow_particle_in_cell_random_nodal_field_h
#define sandglass_flow_particle_in_cell_random_nodal_field_h

#include <sandglass/flow/particle_in_cell/nodal_fields.h>
#include <sandglass/scene/scene.h>

namespace Sandglass
{
  /**
   * Fill the field with numbers between -1 and 1 that look random but depend
   * only on the node's position, so that each partition of the grid gives the
   * same field.
   */
  template <int dim>
  void
  fill_with_random_numbers(NodalField<dim> &field, const Scene<dim> &scene);
} // namespace Sandglass

#endif
