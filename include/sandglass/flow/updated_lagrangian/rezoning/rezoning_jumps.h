#ifndef sandglass_flow_updated_lagrangian_rezoning_rezoning_jumps_h
#define sandglass_flow_updated_lagrangian_rezoning_rezoning_jumps_h

#include <sandglass/flow/updated_lagrangian/rezoning/body_totals.h>

#include <string>

namespace Sandglass
{
  /// What a re-zoning has changed, summed up over the bodies.
  struct RezoningJumps
  {
    BodyTotals before;
    /// On the new mesh, before mass and momentum were restored.
    BodyTotals mapped;
    BodyTotals after;

    unsigned int n_bodies       = 0;
    unsigned int n_cells        = 0; ///< of the new mesh
    unsigned int n_nodes        = 0; ///< of the new mesh
    unsigned int n_straightened = 0; ///< boundary edges, see NewMesh
    unsigned int n_limited      = 0; ///< quadrature points, see PatchRecovery
    /// Nodes so far outside of the old mesh that they were projected (see
    /// PointLocator), and the farthest one's distance in m.
    unsigned int n_projected = 0;
    double       farthest    = 0.;

    /// One line for the log. Jumps of mass, energy and area are relative;
    /// momentum is given over mass, as a velocity in m/s.
    std::string
    description() const;
  };
} // namespace Sandglass

#endif
