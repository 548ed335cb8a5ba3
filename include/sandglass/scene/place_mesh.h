#ifndef sandglass_scene_place_mesh_h
#define sandglass_scene_place_mesh_h

#include <sandglass/continuum/formulation.h>
#include <sandglass/scene/mesh.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /**
   * Move a mesh so that its axis is at x = 0 and its outlet's lowest level, or
   * without an outlet the material's bottom, at y = 0; mirror an axisymmetric
   * one that lies left of its axis. Where the axis goes on below the outlet,
   * particles must not pass it, so faces there become axis that are named as
   * side or bottom of the fall region.
   *
   * Throws InputError if the axis isn't one vertical line at the end of the
   * section, if material lies below the outlet, or if an axisymmetric section
   * crosses x = 0.
   *
   * @param warnings  takes what deserves the user's attention.
   */
  template <int dim>
  void
  place_mesh(Mesh<dim>                &mesh,
             const Formulation         formulation,
             std::vector<std::string> &warnings);

  /// In three dimensions the faces of the axis are symmetry planes, which come
  /// to x = 0 and z = 0.
  template <>
  void
  place_mesh<3>(Mesh<3>                  &mesh,
                const Formulation         formulation,
                std::vector<std::string> &warnings);

  template <>
  void
  place_mesh<2>(Mesh<2>                  &mesh,
                const Formulation         formulation,
                std::vector<std::string> &warnings);
} // namespace Sandglass

#endif
