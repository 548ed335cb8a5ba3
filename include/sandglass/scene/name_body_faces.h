#ifndef sandglass_scene_name_body_faces_h
#define sandglass_scene_name_body_faces_h

#include <sandglass/scene/mesh.h>
#include <sandglass/scene/silo_body.h>

namespace Sandglass
{
  /**
   * Give the mesh of a silo's body the faces of its boundary and of its outlet.
   * Where they lie tells what they are: at a symmetry plane, at the material's
   * surface, on the vertical wall, on the hopper, at the outlet level, or at
   * the fall region's border.
   *
   * Vertices at one of these levels and planes are put there exactly.
   */
  void
  name_body_faces(Mesh<3> &mesh, const SiloBody &body);
} // namespace Sandglass

#endif
