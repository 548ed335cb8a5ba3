#ifndef sandglass_scene_headroom_h
#define sandglass_scene_headroom_h

#include <sandglass/scene/mesh.h>

namespace Sandglass
{
  /**
   * Add empty cells above the faces of the top, in rows as high as these faces
   * are long on average: when an outlet opens, the material that it unloads
   * throws up the surface. What bounds the mesh below the ends of the top
   * goes on beside these cells, which the new top closes; the old one stays
   * the name of the material's surface.
   *
   * Throws InputError if a face of the top is vertical.
   *
   * @param height  of all rows together, in m; 0 leaves the mesh as it is.
   */
  template <int dim>
  void
  add_headroom(Mesh<dim> &mesh, const double height);

  template <>
  void
  add_headroom<2>(Mesh<2> &mesh, const double height);

  template <>
  void
  add_headroom<3>(Mesh<3> &mesh, const double height);
} // namespace Sandglass

#endif
