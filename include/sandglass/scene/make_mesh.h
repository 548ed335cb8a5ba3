#ifndef sandglass_scene_make_mesh_h
#define sandglass_scene_make_mesh_h

#include <sandglass/scene/mesh.h>
#include <sandglass/scene/scene_parameters.h>

#include <mpi.h>

#include <string>

namespace Sandglass
{
  /**
   * The silo of the parameters in this dimension, meshed by Gmsh. In two: its
   * half or whole section: outlet
   * level at y = 0, middle of the silo at x = 0, the fall region below an open
   * outlet.
   */
  template <int dim>
  Mesh<dim>
  mesh_silo(const SceneParameters &parameters);

  template <>
  Mesh<2>
  mesh_silo<2>(const SceneParameters &parameters);

  /**
   * Read a mesh that Gmsh can open. Lines must belong to physical groups named
   * as in boundary_role_names, or to further walls that Walls/Friction angles
   * names (see make_walls()), surfaces to groups `material` (filled) or
   * `fall_region`. Throws InputError that names what is missing.
   */
  template <int dim>
  Mesh<dim>
  read_mesh(const std::string &filename, const CellType cell_type);

  /**
   * The mesh that the parameters ask for, made on rank 0, sorted along a curve,
   * and the same on each rank. Errors are thrown on each rank.
   */
  template <int dim>
  Mesh<dim>
  make_mesh(const SceneParameters &parameters, const MPI_Comm communicator);
} // namespace Sandglass

#endif
