#include <sandglass/base/exceptions.h>
#include <sandglass/scene/headroom.h>
#include <sandglass/scene/mesh_faces.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace Sandglass
{
  using namespace dealii;

  namespace
  {
    using Face = Mesh<2>::Face;

    /// The top's faces that end the mesh, each from left to right.
    std::vector<Face>
    find_top(const Mesh<2> &mesh)
    {
      const CellsAtFaces<2> cells_at = cells_at_faces(mesh);
      std::vector<Face>     top;
      for (const Face &face : mesh.faces)
        if (face.role == BoundaryRole::top &&
            cells_at.at(key_of<2>(face.vertices, 2)).size() == 1)
          top.push_back(face);
      for (Face &face : top)
        {
          auto &[left, right]     = face.vertices;
          const Tensor<1, 2> edge = mesh.vertices[right] - mesh.vertices[left];
          constexpr double   smallest_cosine = 1e-6;
          if (std::abs(edge[0]) < smallest_cosine * edge.norm())
            throw InputError("Scene",
                             "Headroom",
                             "other than 0",
                             "allowed is 0 with a mesh whose top has vertical "
                             "edges");
          if (edge[0] < 0.)
            std::swap(left, right);
        }
      return top;
    }



    double
    mean_length(const Mesh<2> &mesh, const std::vector<Face> &faces)
    {
      double length = 0.;
      for (const Face &face : faces)
        length += mesh.vertices[face.vertices[0]].distance(
          mesh.vertices[face.vertices[1]]);
      return length / faces.size();
    }



    /// From a vertex of the old top up to the new one.
    using Column = std::vector<unsigned int>;

    Column
    add_column(Mesh<2>           &mesh,
               const unsigned int vertex,
               const unsigned int n_rows,
               const double       height)
    {
      Column column{vertex};
      for (unsigned int row = 1; row <= n_rows; ++row)
        {
          column.push_back(mesh.vertices.size());
          mesh.vertices.push_back(mesh.vertices[vertex] +
                                  Tensor<1, 2>({0., height * row / n_rows}));
        }
      return column;
    }



    void
    add_cells(Mesh<2>           &mesh,
              const Column      &left,
              const Column      &right,
              const unsigned int row)
    {
      const unsigned int a = left[row], b = right[row], c = right[row + 1],
                         d = left[row + 1];
      if (mesh.cell_type == CellType::quadrilateral)
        mesh.cells.push_back({{{a, b, c, d}}, false});
      else
        {
          mesh.cells.push_back({{{a, b, c}}, false});
          mesh.cells.push_back({{{a, c, d}}, false});
        }
    }
  } // namespace



  template <>
  void
  add_headroom<2>(Mesh<2> &mesh, const double height)
  {
    if (height == 0.)
      return;
    const std::vector<Face> top = find_top(mesh);
    if (top.empty())
      return;
    const unsigned int n_rows = std::ceil(height / mean_length(mesh, top));

    std::map<unsigned int, Column> columns;
    for (const Face &face : top)
      for (const unsigned int vertex : face.vertices)
        if (columns.count(vertex) == 0)
          columns[vertex] = add_column(mesh, vertex, n_rows, height);

    std::vector<Face> sides;
    for (const Face &face : mesh.faces)
      if (face.role != BoundaryRole::top)
        for (const unsigned int vertex : face.vertices)
          if (const auto column = columns.find(vertex); column != columns.end())
            for (unsigned int row = 0; row < n_rows; ++row)
              {
                sides.push_back(face);
                sides.back().vertices = {
                  {column->second[row], column->second[row + 1]}};
              }
    mesh.faces.insert(mesh.faces.end(), sides.begin(), sides.end());

    for (Face face : top)
      {
        const Column &left  = columns.at(face.vertices[0]),
                     &right = columns.at(face.vertices[1]);
        for (unsigned int row = 0; row < n_rows; ++row)
          add_cells(mesh, left, right, row);
        face.vertices = {{left[n_rows], right[n_rows]}};
        mesh.faces.push_back(face);
      }
  }
} // namespace Sandglass
