#ifndef sandglass_scene_silo_section_h
#define sandglass_scene_silo_section_h

#include <sandglass/scene/scene_parameters.h>

namespace Sandglass
{
  /// The physical surface's name in a mesh for what is filled at the start,
  inline constexpr char material_group[] = "material";
  /// and for the region below an open outlet.
  inline constexpr char fall_region_group[] = "fall_region";

  /**
   * Add the silo's section to Gmsh, which must be open: points, lines in
   * physical groups named as in boundary_role_names, surfaces in the groups
   * above, and for quadrilaterals how to divide them.
   */
  void
  add_silo_section(const SceneParameters &parameters);
} // namespace Sandglass

#endif
