#ifndef sandglass_scene_body_plan_h
#define sandglass_scene_body_plan_h

#include <sandglass/scene/silo_body.h>

#include <array>
#include <vector>

namespace Sandglass
{
  /**
   * Quadrilaterals of which layers of hexahedra are made: a silo seen from
   * above. A vertex moves from `at_outlet` at the outlet level to `at_wall` at
   * the foot of the vertical wall, which without a hopper are the same. Points
   * are (x, z), in m.
   */
  struct BodyPlan
  {
    std::vector<dealii::Point<2>> at_wall, at_outlet;

    /// Vertices around each cell.
    std::vector<std::array<unsigned int, 4>> cells;
    /// Whether each cell lies above the outlet.
    std::vector<bool> is_over_outlet;
  };

  /**
   * The plan of a silo: rows along x and z where wall and outlet have straight
   * sides, else a square core in rings that turn from the outlet's shape to the
   * wall's.
   */
  BodyPlan
  make_body_plan(const SiloBody &body, const Resolution &resolution);

  /// What make_body_plan() makes of the second kind.
  BodyPlan
  plan_of_rings(const SiloBody &body, const Resolution &resolution);
} // namespace Sandglass

#endif
