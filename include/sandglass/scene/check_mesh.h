#ifndef sandglass_scene_check_mesh_h
#define sandglass_scene_check_mesh_h

#include <sandglass/scene/mesh.h>
#include <sandglass/scene/scene_parameters.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /// Throws InputError where gravity points upwards, or beside a symmetry plane
  /// or axis.
  template <int dim>
  void
  check_gravity(const SceneParameters &parameters, const Mesh<dim> &mesh);

  /**
   * Doubt that lengths are in metres where no silo is as large or as small.
   *
   * @param warnings  takes the doubt.
   */
  template <int dim>
  void
  doubt_lengths(const Mesh<dim> &mesh, std::vector<std::string> &warnings);
} // namespace Sandglass

#endif
