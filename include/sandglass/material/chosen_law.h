#ifndef sandglass_material_chosen_law_h
#define sandglass_material_chosen_law_h

#include <sandglass/material/material_constants.h>
#include <sandglass/material/state_variable.h>

#include <vector>

/**
 * @file
 * What the law that the constants ask for says of itself, for who doesn't
 * compute with it.
 */

namespace Sandglass
{
  std::vector<StateVariable>
  state_variables_of_law(const MaterialConstants &constants);

  /// See the laws' own constant of this name.
  bool
  dissipation_can_fall(const MaterialConstants &constants);
} // namespace Sandglass

#endif
