#ifndef sandglass_scene_mesh_outlet_h
#define sandglass_scene_mesh_outlet_h

#include <sandglass/scene/mesh.h>
#include <sandglass/scene/scene_parameters.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /**
   * An outlet of a mesh: edges or faces that hang together. Lengths in m, of
   * the whole outlet where a symmetry plane or axis cuts it.
   */
  struct MeshOutlet
  {
    /// In three dimensions the smaller of its lengths along x and z.
    double width = 0.;
    /// Length of the edges at its lips, the largest one; in three dimensions
    /// across the lip. 0 if no wall ends there.
    double edge_at_lip = 0.;

    /// Cells across the outlet if all were as large as those at its lips,
    /// which is where coarse cells narrow the flow.
    double
    n_cells() const
    {
      return width / edge_at_lip;
    }
  };

  /// The outlets of a mesh.
  template <int dim>
  std::vector<MeshOutlet>
  mesh_outlets(const Mesh<dim> &mesh);

  template <>
  std::vector<MeshOutlet>
  mesh_outlets<2>(const Mesh<2> &mesh);

  template <>
  std::vector<MeshOutlet>
  mesh_outlets<3>(const Mesh<3> &mesh);

  /**
   * Doubt a mesh whose cells are too large for its outlet: how many there are,
   * what error to expect, and what to set. A closed outlet needs none.
   *
   * @param warnings  takes the doubt.
   */
  template <int dim>
  void
  doubt_outlet(const SceneParameters    &parameters,
               const Mesh<dim>          &mesh,
               std::vector<std::string> &warnings);
} // namespace Sandglass

#endif
