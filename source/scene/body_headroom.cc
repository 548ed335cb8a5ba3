#include <sandglass/base/exceptions.h>
#include <sandglass/scene/body_cells.h>
#include <sandglass/scene/headroom.h>
#include <sandglass/scene/mesh_cells.h>
#include <sandglass/walls/face_geometry.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace Sandglass
{
  using namespace dealii;

  namespace
  {
    using Face = Mesh<3>::Face;
    /// From a vertex of the old top up to the new one.
    using Columns = std::map<unsigned int, std::vector<unsigned int>>;



    /// The faces of the top, and the length of their edges on average.
    std::vector<Face>
    find_top(const Mesh<3> &mesh, double &mean_length)
    {
      std::vector<Face>  top;
      double             length = 0.;
      const unsigned int n      = mesh.vertices_per_face();
      for (const Face &face : mesh.faces)
        {
          if (face.role != BoundaryRole::top)
            continue;
          top.push_back(face);
          std::array<Point<3>, 3> corners;
          for (unsigned int v = 0; v < 3; ++v)
            corners[v] = mesh.vertices[face.vertices[v]];
          constexpr double smallest_cosine = 1e-6;
          if (std::abs(unit_normal<3>(corners)[1]) < smallest_cosine)
            throw InputError("Scene",
                             "Headroom",
                             "other than 0",
                             "allowed is 0 with a mesh whose top has vertical "
                             "faces");
          for (unsigned int v = 0; v < n; ++v)
            length += mesh.vertices[face.vertices[v]].distance(
              mesh.vertices[face.vertices[(v + 1) % n]]);
        }
      mean_length = top.empty() ? 0. : length / (n * top.size());
      return top;
    }



    Columns
    add_columns(Mesh<3>                 &mesh,
                const std::vector<Face> &top,
                const unsigned int       n_rows,
                const double             height)
    {
      Columns columns;
      for (const Face &face : top)
        for (unsigned int v = 0; v < mesh.vertices_per_face(); ++v)
          {
            auto &column = columns[face.vertices[v]];
            if (!column.empty())
              continue;
            column.push_back(face.vertices[v]);
            const Point<3> foot = mesh.vertices[face.vertices[v]];
            for (unsigned int row = 1; row <= n_rows; ++row)
              {
                column.push_back(mesh.vertices.size());
                mesh.vertices.push_back(
                  foot + Tensor<1, 3>({0., height * row / n_rows, 0.}));
              }
          }
      return columns;
    }



    void
    add_cells(Mesh<3>           &mesh,
              const Columns     &columns,
              const Face        &face,
              const unsigned int row)
    {
      const unsigned int        n = mesh.vertices_per_face();
      std::vector<unsigned int> feet(face.vertices.begin(),
                                     face.vertices.begin() + n);
      Mesh<3>::Cell             cell{{}, false};
      if (mesh.cell_type == CellType::hexahedron)
        {
          for (unsigned int v = 0; v < 4; ++v)
            {
              cell.vertices[v]     = columns.at(feet[v])[row];
              cell.vertices[v + 4] = columns.at(feet[v])[row + 1];
            }
          mesh.cells.push_back(cell);
          return;
        }
      // A prism in three tetrahedra: diagonals go up from the foot that has the
      // smaller index, in this prism and in its neighbours.
      std::sort(feet.begin(), feet.end());
      for (unsigned int turn = 0; turn < 3; ++turn)
        {
          unsigned int v = 0;
          for (unsigned int i = 0; i <= turn; ++i)
            cell.vertices[v++] = columns.at(feet[i])[row];
          for (unsigned int i = turn; i < 3; ++i)
            cell.vertices[v++] = columns.at(feet[i])[row + 1];
          mesh.cells.push_back(cell);
        }
    }



    /// The faces between two columns, which the face below them names.
    void
    add_sides(Mesh<3>                         &mesh,
              const std::vector<unsigned int> &a,
              const std::vector<unsigned int> &b,
              Face                             named)
    {
      constexpr unsigned int unused = numbers::invalid_unsigned_int;
      for (unsigned int row = 0; row + 1 < a.size(); ++row)
        if (mesh.cell_type == CellType::hexahedron)
          {
            named.vertices = {{a[row], b[row], b[row + 1], a[row + 1]}};
            mesh.faces.push_back(named);
          }
        else
          {
            named.vertices = {{a[row], b[row], b[row + 1], unused}};
            mesh.faces.push_back(named);
            named.vertices = {{a[row], b[row + 1], a[row + 1], unused}};
            mesh.faces.push_back(named);
          }
    }
  } // namespace



  template <>
  void
  add_headroom<3>(Mesh<3> &mesh, const double height)
  {
    double                  mean_length;
    const std::vector<Face> top = find_top(mesh, mean_length);
    if (height == 0. || top.empty())
      return;
    const unsigned int n_rows  = std::ceil(height / mean_length);
    const Columns      columns = add_columns(mesh, top, n_rows, height);

    // Edges at which the top ends belong to one of its faces.
    const unsigned int n = mesh.vertices_per_face();
    std::set<std::pair<unsigned int, unsigned int>> rim;
    for (const Face &face : top)
      for (unsigned int v = 0; v < n; ++v)
        {
          const std::pair<unsigned int, unsigned int> edge =
            std::minmax(face.vertices[v], face.vertices[(v + 1) % n]);
          if (rim.erase(edge) == 0)
            rim.insert(edge);
        }
    const std::vector<Face> below = mesh.faces;
    for (const Face &face : below)
      for (unsigned int v = 0; v < n && face.role != BoundaryRole::top; ++v)
        {
          const std::pair<unsigned int, unsigned int> edge =
            std::minmax(face.vertices[v], face.vertices[(v + 1) % n]);
          if (rim.count(edge) > 0)
            add_sides(mesh,
                      columns.at(edge.first),
                      columns.at(edge.second),
                      face);
        }
    for (Face face : top)
      {
        for (unsigned int row = 0; row < n_rows; ++row)
          add_cells(mesh, columns, face, row);
        for (unsigned int v = 0; v < n; ++v)
          face.vertices[v] = columns.at(face.vertices[v])[n_rows];
        mesh.faces.push_back(face);
      }
    orient_cells(mesh);
    order_faces(mesh);
  }
} // namespace Sandglass
