#ifndef sandglass_flow_updated_lagrangian_motion_rezoning_options_h
#define sandglass_flow_updated_lagrangian_motion_rezoning_options_h

#include <sandglass/flow/updated_lagrangian/motion/motion_setting.h>
#include <sandglass/flow/updated_lagrangian/rezoning/rezone.h>
#include <sandglass/flow/updated_lagrangian/rezoning/rezoning_criterion.h>

namespace Sandglass
{
  /// ElementGrid's quadrature of stresses in triangles.
  Quadrature<2>
  stress_quadrature(const unsigned int order);

  /// What the mesh must not do, lest the material be meshed anew.
  RezoningCriterion
  rezoning_criterion(const MotionSetting &setting);

  /// How the material within a mesh's boundary is meshed anew: with nodes at
  /// the walls' ends and smaller elements at the lip and where material is
  /// thin. `setting` has to outlive the result.
  RezoningOptions
  rezoning_options(const MotionSetting &setting, const TriangleMesh &mesh);
} // namespace Sandglass

#endif
