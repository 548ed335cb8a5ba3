#ifndef sandglass_scene_body_hexahedra_h
#define sandglass_scene_body_hexahedra_h

#include <sandglass/scene/mesh.h>
#include <sandglass/scene/silo_body.h>

namespace Sandglass
{
  /// The hexahedra of a silo's body and its fall region, in layers between
  /// copies of its plan. Faces have no names yet.
  Mesh<3>
  mesh_body_by_hexahedra(const SiloBody &body, const Resolution &resolution);
} // namespace Sandglass

#endif
