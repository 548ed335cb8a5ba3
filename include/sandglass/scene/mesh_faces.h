#ifndef sandglass_scene_mesh_faces_h
#define sandglass_scene_mesh_faces_h

#include <sandglass/scene/mesh.h>

#include <array>
#include <map>
#include <vector>

namespace Sandglass
{
  /// A face's vertices in order, by which it is known; what a simplex
  /// lacks comes last.
  template <int dim>
  using FaceKey =
    std::array<unsigned int, Mesh<dim>::most_vertices_per_cell / 2>;

  /// @param n  how many vertices the face has.
  template <int dim>
  FaceKey<dim>
  key_of(FaceKey<dim> vertices, const unsigned int n);

  /// The indices of the cells at each face of a mesh.
  template <int dim>
  using CellsAtFaces = std::map<FaceKey<dim>, std::vector<unsigned int>>;

  template <int dim>
  CellsAtFaces<dim>
  cells_at_faces(const Mesh<dim> &mesh);

  template <int dim>
  std::vector<typename Mesh<dim>::Face>
  faces_with_role(const Mesh<dim> &mesh, const BoundaryRole role);

  /// The vector area of a face in m^2, to the side from which its vertices are
  /// counterclockwise.
  dealii::Tensor<1, 3>
  vector_area(const Mesh<3> &mesh, const Mesh<3>::Face &face);
} // namespace Sandglass

#endif
