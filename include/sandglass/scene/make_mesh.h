#ifndef sandglass_scene_make_mesh_h
#define sandglass_scene_make_mesh_h

#include <sandglass/scene/mesh.h>
#include <sandglass/scene/scene_parameters.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /**
   * The silo of the parameters in this dimension: in two its half or whole
   * section, in three its quarter, half or whole body. Outlet level at y = 0,
   * middle of the silo at x = 0 (and z = 0), the fall region below an open
   * outlet. By Gmsh; hexahedra are made in layers.
   */
  template <int dim>
  Mesh<dim>
  mesh_silo(const SceneParameters &parameters);

  template <>
  Mesh<2>
  mesh_silo<2>(const SceneParameters &parameters);

  template <>
  Mesh<3>
  mesh_silo<3>(const SceneParameters &parameters);

  /// How far the silo goes on above what mesh_silo() meshes, in m: in three
  /// dimensions that ends at the material's surface.
  template <int dim>
  double
  space_above(const SceneParameters &)
  {
    return 0.;
  }

  template <>
  double
  space_above<3>(const SceneParameters &parameters);

  /**
   * Read the mesh file of the parameters. Lines must belong to physical groups
   * named as in boundary_role_names, or to further walls that Walls/Friction
   * angles names (see make_walls()), surfaces to groups `material` (filled) or
   * `fall_region`, which a closed outlet leaves out; in three dimensions,
   * surfaces and volumes. The mesh is moved to where
   * mesh_silo() has its own. Throws InputError that says what is wrong with the
   * file, and where.
   *
   * @param warnings  takes what deserves the user's attention.
   */
  template <int dim>
  Mesh<dim>
  read_mesh(const SceneParameters    &parameters,
            std::vector<std::string> &warnings);

  /**
   * The mesh that the parameters ask for, made on rank 0, sorted along a curve,
   * and the same on each rank. Errors are thrown on each rank.
   *
   * @param warnings  on rank 0, takes what deserves the user's attention.
   */
  template <int dim>
  Mesh<dim>
  make_mesh(const SceneParameters    &parameters,
            const MPI_Comm            communicator,
            std::vector<std::string> *warnings = nullptr);
} // namespace Sandglass

#endif
