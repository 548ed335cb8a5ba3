#ifndef sandglass_flow_updated_lagrangian_motion_rezone_material_h
#define sandglass_flow_updated_lagrangian_motion_rezone_material_h

#include <sandglass/flow/updated_lagrangian/motion/moving_body.h>

#include <string>

namespace Sandglass
{
  /// Material on a new mesh, and what was not kept.
  struct RezonedMaterial
  {
    MaterialState state;             ///< without cells where nothing is left
    double        mass_below   = 0.; ///< below the fall region, in kg
    double        mass_slivers = 0.; ///< in bodies too small to mesh, in kg
    std::string   description;       ///< for the log
  };

  /**
   * Cut off what has fallen, and mesh the rest anew within its boundary, with
   * nodes at the walls' ends, nodes of walls on their lines, and smaller
   * elements at the lip. Each body keeps its mass to rounding. Throws RunError
   * where a body can't be meshed.
   */
  RezonedMaterial
  rezone_material(const MotionSetting &setting, const MaterialState &state);
} // namespace Sandglass

#endif
