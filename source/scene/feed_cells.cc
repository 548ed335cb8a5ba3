#include <sandglass/choices/choose_kinematics.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/scene/feed_cells.h>
#include <sandglass/scene/mesh_faces.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace Sandglass
{
  namespace
  {
    /// Call `function(face, cells)` for the faces of the top, inner ones too.
    template <int dim, typename Function>
    void
    for_each_top_face(const Mesh<dim> &mesh, const Function &function)
    {
      const CellsAtFaces<dim> cells_at = cells_at_faces(mesh);
      const unsigned int      n        = mesh.vertices_per_face();
      for (const auto &face : mesh.faces)
        if (face.role == BoundaryRole::top)
          {
            const auto entry = cells_at.find(key_of<dim>(face.vertices, n));
            if (entry != cells_at.end())
              function(face, entry->second);
          }
    }



    /// Of a face as seen from above: length in the plane.
    template <int dim>
    double
    area_from_above(const Mesh<dim> &mesh, const typename Mesh<dim>::Face &face)
    {
      const auto x = [&](const unsigned int v) {
        return mesh.vertices[face.vertices[v]][0];
      };
      const auto z = [&](const unsigned int v) {
        return mesh.vertices[face.vertices[v]][dim - 1];
      };
      if (dim == 2)
        return std::abs(x(1) - x(0));
      double             twice = 0.;
      const unsigned int n     = mesh.vertices_per_face();
      for (unsigned int v = 0; v < n; ++v)
        twice += x(v) * z((v + 1) % n) - x((v + 1) % n) * z(v);
      return std::abs(twice) / 2.;
    }
  } // namespace



  template <int dim>
  std::vector<unsigned int>
  surface_cells(const Mesh<dim> &mesh)
  {
    std::set<unsigned int> surface;
    for_each_top_face(mesh, [&](const auto &face, const auto &cells) {
      if (std::any_of(cells.begin(), cells.end(), [&](const auto cell) {
            return mesh.cells[cell].is_filled;
          }))
        surface.insert(face.vertices.begin(),
                       face.vertices.begin() + mesh.vertices_per_face());
    });
    std::vector<unsigned int> result;
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      {
        const auto vertices = mesh.cells[cell].vertices.begin();
        if (mesh.cells[cell].is_filled &&
            std::any_of(vertices,
                        vertices + mesh.vertices_per_cell(),
                        [&](const unsigned int vertex) {
                          return surface.count(vertex) > 0;
                        }))
          result.push_back(cell);
      }
    return result;
  }



  template <int dim>
  std::vector<unsigned int>
  top_cells(const Mesh<dim> &mesh)
  {
    std::set<unsigned int> top;
    for_each_top_face(mesh, [&](const auto &, const auto &cells) {
      if (cells.size() == 1)
        top.insert(cells[0]);
    });
    return {top.begin(), top.end()};
  }



  template <int dim>
  dealii::Point<dim>
  middle_of_cell(const Mesh<dim> &mesh, const unsigned int cell)
  {
    dealii::Point<dim> result;
    for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
      result += mesh.vertices[mesh.cells[cell].vertices[v]] /
                static_cast<double>(mesh.vertices_per_cell());
    return result;
  }



  template <int dim>
  double
  opening_area(const Mesh<dim>                 &mesh,
               const std::vector<unsigned int> &cells,
               const Formulation                formulation)
  {
    double area = 0.;
    for_each_top_face(mesh, [&](const auto &face, const auto &at_face) {
      if (at_face.size() != 1 ||
          !std::binary_search(cells.begin(), cells.end(), at_face[0]))
        return;
      dealii::Point<dim> middle;
      for (unsigned int v = 0; v < mesh.vertices_per_face(); ++v)
        middle += mesh.vertices[face.vertices[v]] /
                  static_cast<double>(mesh.vertices_per_face());
      area += area_from_above(mesh, face) * measure<dim>(formulation, middle);
    });
    return area;
  }



#define INSTANTIATE(dim)                                                                  \
  template std::vector<unsigned int> surface_cells<dim>(const Mesh<dim> &);               \
  template std::vector<unsigned int> top_cells<dim>(const Mesh<dim> &);                   \
  template dealii::Point<dim>        middle_of_cell<dim>(const Mesh<dim> &,               \
                                                  const unsigned int);             \
  template double                    opening_area<dim>(const Mesh<dim> &,                 \
                                    const std::vector<unsigned int> &, \
                                    const Formulation);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
