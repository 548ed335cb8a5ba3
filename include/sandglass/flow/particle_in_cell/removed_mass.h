#ifndef sandglass_flow_particle_in_cell_removed_mass_h
#define sandglass_flow_particle_in_cell_removed_mass_h

namespace Sandglass
{
  /// Masses that have left the grid, on this rank, in kg.
  struct RemovedMass
  {
    double discharged = 0.; ///< through the fall region's open boundary
    double lost       = 0.; ///< anywhere else
  };
} // namespace Sandglass

#endif
