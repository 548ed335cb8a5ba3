#ifndef sandglass_scene_silo_section_h
#define sandglass_scene_silo_section_h

#include <sandglass/scene/scene_parameters.h>
#include <sandglass/scene/section_surface.h>

namespace Sandglass
{
  /// The physical surface's name in a mesh for what is filled at the start,
  inline constexpr char material_group[] = "material";
  /// and for the region below an open outlet.
  inline constexpr char fall_region_group[] = "fall_region";
  /// What is empty above the material, also where the outlet is closed.
  inline constexpr char space_group[] = "space";

  /**
   * Add the silo's section to Gmsh, which must be open: points, lines in
   * physical groups named as in boundary_role_names, surfaces in the groups
   * above, and for quadrilaterals how to divide them.
   *
   * @param filling  up to where the section is material.
   */
  void
  add_silo_section(const SceneParameters &parameters,
                   const SectionSurface  &filling);
} // namespace Sandglass

#endif
