#ifndef sandglass_output_section_wall_gauge_h
#define sandglass_output_section_wall_gauge_h

#include <sandglass/output/section_wall_tractions.h>

#include <vector>

namespace Sandglass
{
  /// Whether a point is on a wall of the mesh, as far as rounding goes.
  bool
  is_on_wall(const Scene<2> &scene, const Point<2> &point);

  /**
   * Pressure and friction at a point of a section's wall: linear between the
   * tractions of the two nodes beside it. NaN where no wall is, or no
   * tractions.
   *
   * @param tractions  at all nodes of all walls, along them.
   */
  WallPressure
  traction_at(const Point<3>                  &point,
              const std::vector<WallTraction> &tractions);
} // namespace Sandglass

#endif
