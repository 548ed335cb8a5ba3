#ifndef sandglass_flow_particle_in_cell_removed_mass_h
#define sandglass_flow_particle_in_cell_removed_mass_h

#include <sandglass/base/compensated_sum.h>

namespace Sandglass
{
  /// Masses that have left the grid, on this rank, in kg.
  struct RemovedMass
  {
    CompensatedSum discharged; ///< through the fall region's open boundary
    CompensatedSum lost;       ///< anywhere else
  };
} // namespace Sandglass

#endif
