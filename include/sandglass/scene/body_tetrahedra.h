#ifndef sandglass_scene_body_tetrahedra_h
#define sandglass_scene_body_tetrahedra_h

#include <sandglass/scene/mesh.h>
#include <sandglass/scene/silo_body.h>

namespace Sandglass
{
  /**
   * The tetrahedra of a silo's body and its fall region, by Gmsh, which must be
   * open: smaller at the outlet's lip than elsewhere, as the resolution says.
   * Faces have no names yet. Throws std::runtime_error.
   */
  Mesh<3>
  mesh_body_by_tetrahedra(const SiloBody &body, const Resolution &resolution);
} // namespace Sandglass

#endif
