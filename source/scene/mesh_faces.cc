#include <deal.II/grid/reference_cell.h>

#include <sandglass/choices/dimensions.h>
#include <sandglass/scene/mesh_faces.h>

#include <algorithm>
#include <iterator>

namespace Sandglass
{
  using namespace dealii;

  template <int dim>
  FaceKey<dim>
  key_of(FaceKey<dim> vertices, const unsigned int n)
  {
    std::fill(vertices.begin() + n,
              vertices.end(),
              numbers::invalid_unsigned_int);
    std::sort(vertices.begin(), vertices.end());
    return vertices;
  }



  template <int dim>
  CellsAtFaces<dim>
  cells_at_faces(const Mesh<dim> &mesh)
  {
    const bool          has_simplices = is_simplex(mesh.cell_type);
    const ReferenceCell reference     = has_simplices ?
                                          ReferenceCells::get_simplex<dim>() :
                                          ReferenceCells::get_hypercube<dim>();
    // deal.II numbers the vertices of cubes line by line, a Mesh around.
    const auto index_in_mesh = [has_simplices](const unsigned int v) {
      return has_simplices || v % 4 < 2 ? v : v ^ 1u;
    };

    CellsAtFaces<dim> cells_at;
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      for (const unsigned int face : reference.face_indices())
        {
          FaceKey<dim>       vertices{};
          const unsigned int n = mesh.vertices_per_face();
          for (unsigned int v = 0; v < n; ++v)
            vertices[v] = mesh.cells[cell].vertices[index_in_mesh(
              reference.face_to_cell_vertices(face, v, 1))];
          cells_at[key_of<dim>(vertices, n)].push_back(cell);
        }
    return cells_at;
  }



  template <int dim>
  std::vector<typename Mesh<dim>::Face>
  faces_with_role(const Mesh<dim> &mesh, const BoundaryRole role)
  {
    std::vector<typename Mesh<dim>::Face> faces;
    std::copy_if(mesh.faces.begin(),
                 mesh.faces.end(),
                 std::back_inserter(faces),
                 [role](const auto &face) { return face.role == role; });
    return faces;
  }



  Tensor<1, 3>
  vector_area(const Mesh<3> &mesh, const Mesh<3>::Face &face)
  {
    const auto  &x = mesh.vertices;
    Tensor<1, 3> area;
    for (unsigned int v = 1; v + 1 < mesh.vertices_per_face(); ++v)
      area += cross_product_3d(x[face.vertices[v]] - x[face.vertices[0]],
                               x[face.vertices[v + 1]] - x[face.vertices[0]]) /
              2.;
    return area;
  }



#define INSTANTIATE(dim)                                                    \
  template FaceKey<dim>      key_of<dim>(FaceKey<dim>, const unsigned int); \
  template CellsAtFaces<dim> cells_at_faces<dim>(const Mesh<dim> &);        \
  template std::vector<typename Mesh<dim>::Face> faces_with_role<dim>(      \
    const Mesh<dim> &, const BoundaryRole);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
