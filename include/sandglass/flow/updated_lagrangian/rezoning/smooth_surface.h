#ifndef sandglass_flow_updated_lagrangian_rezoning_smooth_surface_h
#define sandglass_flow_updated_lagrangian_rezoning_smooth_surface_h

#include <sandglass/flow/updated_lagrangian/rezoning/boundary_piece.h>

namespace Sandglass
{
  /**
   * Smooth the free surface of a loop where it turns too sharply, as it does in
   * spikes and cracks that the mesh doesn't resolve.
   *
   * Where two pieces of the surface meet at more than `largest_turn` radians,
   * they and a third one become straight pieces through points at the thirds of
   * the way, shifted sidewards so that the area stays the same
   * (kuprat2001). This is repeated as long as there are such turns, some
   * twenty times. Places where the surface meets a wall stay.
   *
   * @return how many places were smoothed.
   */
  unsigned int
  smooth_surface(BoundaryLoop &loop, const double largest_turn);
} // namespace Sandglass

#endif
