#ifndef sandglass_flow_updated_lagrangian_motion_rezone_material_h
#define sandglass_flow_updated_lagrangian_motion_rezone_material_h

#include <sandglass/flow/updated_lagrangian/motion/moving_body.h>
#include <sandglass/flow/updated_lagrangian/rezoning/rezoning_criterion.h>

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

  /// ElementGrid's quadrature of stresses in triangles.
  Quadrature<2>
  stress_quadrature(const unsigned int order);

  /// Mark the boundary edges that lie on walls with the walls' indices.
  void
  mark_walls(TriangleMesh &mesh, const MotionSetting &setting);

  /**
   * Cut off what has fallen, and mesh the rest anew within its boundary, with
   * nodes at the walls' ends, nodes of walls on their lines, and smaller
   * elements at the lip. Each body keeps its mass to rounding. Throws RunError
   * where a body can't be meshed.
   */
  RezonedMaterial
  rezone_material(const MotionSetting &setting, const MaterialState &state);

  /// What the mesh must not do, lest the material be meshed anew.
  RezoningCriterion
  rezoning_criterion(const MotionSetting &setting);
} // namespace Sandglass

#endif
