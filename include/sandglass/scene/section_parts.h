#ifndef sandglass_scene_section_parts_h
#define sandglass_scene_section_parts_h

#include <sandglass/scene/section_geometry.h>

namespace Sandglass
{
  /**
   * For free triangles: one surface for the material, one for what is empty
   * above it, one for the fall region.
   */
  void
  add_outlines(SectionGeometry &section);

  /**
   * For structured quadrilaterals: blocks of material between the corners of
   * the outlet and the hopper, on each an empty one where the silo isn't full,
   * and one for the fall region.
   */
  void
  add_blocks(SectionGeometry &section);
} // namespace Sandglass

#endif
