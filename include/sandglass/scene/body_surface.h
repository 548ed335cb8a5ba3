#ifndef sandglass_scene_body_surface_h
#define sandglass_scene_body_surface_h

#include <sandglass/scene/mesh.h>
#include <sandglass/scene/scene_parameters.h>
#include <sandglass/scene/silo_body.h>

namespace Sandglass
{
  /**
   * The part of a silo body that holds material: its walls end at the fill
   * height. The same body where it is full.
   *
   * Throws InputError where the surface (see FillSurface) isn't between hopper
   * and silo's top.
   */
  SiloBody
  filled_part(const SiloBody &body, const SceneParameters &parameters);

  /// Move the nodes of the filled part's mesh up and down so that its top is
  /// the material's surface: those at the hopper stay.
  void
  move_to_surface(Mesh<3>               &mesh,
                  const SiloBody        &body,
                  const SceneParameters &parameters);
} // namespace Sandglass

#endif
