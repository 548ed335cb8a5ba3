#ifndef sandglass_scene_hopper_slope_h
#define sandglass_scene_hopper_slope_h

#include <sandglass/scene/scene_parameters.h>

namespace Sandglass
{
  /**
   * Whether structured quadrilaterals have less acute corners if the hopper is
   * a block of its own than if columns beside the outlet stand on the hopper's
   * walls. The block's corners have the walls' angles to the horizontal, the
   * columns' those to the vertical.
   */
  bool
  hopper_is_steep(const SceneParameters &parameters);
} // namespace Sandglass

#endif
