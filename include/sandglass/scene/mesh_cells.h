#ifndef sandglass_scene_mesh_cells_h
#define sandglass_scene_mesh_cells_h

#include <sandglass/scene/gmsh_mesh.h>
#include <sandglass/scene/mesh.h>

#include <set>
#include <string>

namespace Sandglass
{
  /**
   * A Mesh with the nodes and cells that Gmsh has found, but no faces yet. A
   * vertex has the index of its node.
   *
   * Throws InputError, which says where, unless each cell is of the type asked
   * for, lies in the space of the mesh, and belongs to one of the groups
   * `material`, `fall_region` and `space`.
   */
  template <int dim>
  Mesh<dim>
  take_cells(const GmshMesh &gmsh_mesh, const CellType cell_type);

  /// Close the outlet of a mesh: only what material fills remains.
  template <int dim>
  void
  leave_out_fall_region(Mesh<dim> &mesh);

  /// The same for a mesh of take_cells(), whose cells of the group `space`
  /// remain as well.
  template <int dim>
  void
  leave_out_fall_region(Mesh<dim> &mesh, const GmshMesh &gmsh_mesh);

  /**
   * Order each cell's vertices counterclockwise, in three dimensions so that
   * its volume is positive. Throws InputError where a cell has no area or
   * volume, or where a quadrilateral or hexahedron isn't convex at its corners.
   */
  template <int dim>
  void
  orient_cells(Mesh<dim> &mesh);

  template <>
  void
  orient_cells<2>(Mesh<2> &mesh);

  template <>
  void
  orient_cells<3>(Mesh<3> &mesh);

  /// Throws InputError where oriented cells lie on each other.
  template <int dim>
  void
  check_overlap(const Mesh<dim> &mesh);

  template <>
  void
  check_overlap<2>(const Mesh<2> &mesh);

  template <>
  void
  check_overlap<3>(const Mesh<3> &mesh);

  /// Names with commas between them, or "none".
  std::string
  list_of(const std::set<std::string> &names);

  /// A place for messages, as in "(0.1, 0.2) m".
  template <int dim>
  std::string
  place(const dealii::Point<dim> &point);
} // namespace Sandglass

#endif
