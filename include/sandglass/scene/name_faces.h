#ifndef sandglass_scene_name_faces_h
#define sandglass_scene_name_faces_h

#include <sandglass/scene/gmsh_mesh.h>
#include <sandglass/scene/mesh.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /**
   * Give a mesh the faces to which Gmsh's physical groups give a name.
   *
   * Throws InputError, which says which names and where, for
   * - faces of the boundary, or between material and fall region, without a
   *   name, and with two names,
   * - names of the boundary's parts at faces inside the mesh: only an outlet
   *   lies between material and fall region, and the material's top if empty
   *   cells are above it,
   * - an outlet that has no fall region below, though the mesh has one,
   * - faces that no cell has. With a closed outlet these are left out.
   *
   * @param warnings  takes what deserves the user's attention.
   */
  template <int dim>
  void
  name_faces(Mesh<dim>                &mesh,
             const GmshMesh           &gmsh_mesh,
             const bool                outlet_is_open,
             std::vector<std::string> &warnings);
} // namespace Sandglass

#endif
