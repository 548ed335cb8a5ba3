#ifndef sandglass_flow_updated_lagrangian_motion_motion_setting_h
#define sandglass_flow_updated_lagrangian_motion_motion_setting_h

#include <deal.II/base/conditional_ostream.h>

#include <sandglass/flow/updated_lagrangian/motion/rigid_walls.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_element.h>
#include <sandglass/flow/updated_lagrangian/static_stage_parameters.h>
#include <sandglass/flow/updated_lagrangian/updated_lagrangian_parameters.h>
#include <sandglass/material/material_parameters.h>

namespace Sandglass
{
  /// What stays the same through a motion: silo, material, method.
  struct MotionSetting
  {
    /// The parameters have to outlive this. Throws InputError for what this
    /// method does not offer.
    MotionSetting(const Scene<2>                    &scene,
                  const MaterialParameters          &material,
                  const WallParameters              &walls,
                  const UpdatedLagrangianParameters &parameters,
                  const StaticStageParameters       &static_parameters);

    const Scene<2>                    &scene;
    const MaterialParameters          &material;
    const WallParameters              &wall_parameters;
    const UpdatedLagrangianParameters &parameters;
    const StaticStageParameters       &static_parameters;

    const std::vector<RigidWall> walls;
    const Depth                  depth;
    double                       element_size; ///< of the scene's mesh, in m
    double                       lowest_level; ///< below it is nothing, in m
  };
} // namespace Sandglass

#endif
