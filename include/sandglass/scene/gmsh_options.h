#ifndef sandglass_scene_gmsh_options_h
#define sandglass_scene_gmsh_options_h

#include <sandglass/scene/scene_parameters.h>

namespace Sandglass
{
  /// Tell Gmsh, which must be open, the algorithm for triangles and the seed.
  void
  set_gmsh_options(const SceneParameters &parameters);
} // namespace Sandglass

#endif
