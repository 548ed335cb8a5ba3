#ifndef sandglass_scene_section_surface_h
#define sandglass_scene_section_surface_h

#include <deal.II/base/point.h>

#include <sandglass/scene/fill_surface.h>
#include <sandglass/scene/scene_parameters.h>

namespace Sandglass
{
  /// Where the material's surface lies in a silo's half or whole section.
  struct SectionSurface
  {
    FillSurface<2> line;
    /// Whether the line is the section's top.
    bool is_top;
    /// y of the section's top, in m.
    double top;
    /// Where the line ends on the walls or the hopper, or at the axis, in m.
    dealii::Point<2> left, right;
  };

  /**
   * The surface that the parameters ask for. Where less than half a cell would
   * fit between a level surface and the silo's top, the section ends at the
   * surface.
   *
   * Throws InputError where the surface doesn't reach the walls or the hopper,
   * and where there is no room for cells below or above it.
   */
  SectionSurface
  section_surface(const SceneParameters &parameters);
} // namespace Sandglass

#endif
