#include <sandglass/base/exceptions.h>
#include <sandglass/scene/body_cells.h>
#include <sandglass/scene/mesh_cells.h>
#include <sandglass/scene/mesh_faces.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace Sandglass
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    /// Of the longest edge's cube. Cells thinner than that have no meaningful
    /// derivatives.
    constexpr double least_volume = 1e-9;

    using Cell = Mesh<3>::Cell;



    /// Six times the volume of the tetrahedron of four vertices, positive if
    /// its edges from the first are right-handed.
    double
    triple_product(const Mesh<3>     &mesh,
                   const unsigned int a,
                   const unsigned int b,
                   const unsigned int c,
                   const unsigned int d)
    {
      const auto &x = mesh.vertices;
      return dealii::cross_product_3d(x[b] - x[a], x[c] - x[a]) * (x[d] - x[a]);
    }



    /// Of a tetrahedron the triple product of its edges, of a hexahedron those
    /// at its vertices.
    std::vector<double>
    corner_volumes(const Mesh<3> &mesh, const Cell &cell)
    {
      const auto &v = cell.vertices;
      if (is_simplex(mesh.cell_type))
        return {triple_product(mesh, v[0], v[1], v[2], v[3])};
      std::vector<double> volumes;
      for (unsigned int i = 0; i < 4; ++i)
        {
          const unsigned int next = (i + 1) % 4, last = (i + 3) % 4;
          volumes.push_back(
            triple_product(mesh, v[i], v[next], v[last], v[i + 4]));
          volumes.push_back(
            triple_product(mesh, v[i + 4], v[last + 4], v[next + 4], v[i]));
        }
      return volumes;
    }



    Point<3>
    center_of(const Mesh<3> &mesh, const Cell &cell)
    {
      Point<3>           center;
      const unsigned int n = mesh.vertices_per_cell();
      for (unsigned int v = 0; v < n; ++v)
        center += mesh.vertices[cell.vertices[v]] / n;
      return center;
    }



    double
    longest_distance(const Mesh<3> &mesh, const Cell &cell)
    {
      double longest = 0.;
      for (unsigned int v = 1; v < mesh.vertices_per_cell(); ++v)
        longest = std::max(longest,
                           mesh.vertices[cell.vertices[v]].distance(
                             mesh.vertices[cell.vertices[0]]));
      return longest;
    }



    /// Face number `face` of a cell, from its smallest vertex on.
    std::array<unsigned int, 4>
    face_from_smallest(const Mesh<3>                     &mesh,
                       const Cell                        &cell,
                       const std::array<unsigned int, 4> &face)
    {
      std::array<unsigned int, 4> vertices;
      for (unsigned int v = 0; v < 4; ++v)
        vertices[v] = cell.vertices[face[v]];
      const auto end = vertices.begin() + mesh.vertices_per_face();
      std::rotate(vertices.begin(),
                  std::min_element(vertices.begin(), end),
                  end);
      std::fill(end, vertices.end(), dealii::numbers::invalid_unsigned_int);
      return vertices;
    }
  } // namespace



  const FacesOfCell &
  faces_of_cell(const CellType cell_type)
  {
    static const FacesOfCell of_tetrahedron = {{{0, 2, 1, 0}},
                                               {{0, 1, 3, 0}},
                                               {{1, 2, 3, 1}},
                                               {{0, 3, 2, 0}}};
    static const FacesOfCell of_hexahedron  = {{{0, 3, 2, 1}},
                                               {{4, 5, 6, 7}},
                                               {{0, 1, 5, 4}},
                                               {{1, 2, 6, 5}},
                                               {{2, 3, 7, 6}},
                                               {{3, 0, 4, 7}}};
    return is_simplex(cell_type) ? of_tetrahedron : of_hexahedron;
  }



  void
  order_faces(Mesh<3> &mesh)
  {
    const CellsAtFaces<3> cells_at = cells_at_faces(mesh);
    const unsigned int    n        = mesh.vertices_per_face();
    for (auto &named : mesh.faces)
      {
        const FaceKey<3> key   = key_of<3>(named.vertices, n);
        const auto      &cells = cells_at.at(key);
        const Cell      &cell =
          mesh.cells[cells.size() == 2 && !mesh.cells[cells[0]].is_filled ?
                       cells[1] :
                       cells[0]];
        for (const auto &face : faces_of_cell(mesh.cell_type))
          {
            const auto vertices = face_from_smallest(mesh, cell, face);
            if (key_of<3>(vertices, n) == key)
              named.vertices = vertices;
          }
      }
  }



  template <>
  void
  check_overlap<3>(const Mesh<3> &mesh)
  {
    // Cells of positive volume that share a face go around it to either side.
    std::set<std::array<unsigned int, 4>> faces;
    for (const auto &cell : mesh.cells)
      for (const auto &face : faces_of_cell(mesh.cell_type))
        if (const auto vertices = face_from_smallest(mesh, cell, face);
            !faces.insert(vertices).second)
          throw InputError("two cells overlap: they lie on the same side of "
                           "the face at " +
                           place(mesh.vertices[vertices[0]]) + ", " +
                           place(mesh.vertices[vertices[1]]) + " and " +
                           place(mesh.vertices[vertices[2]]) +
                           "; allowed are cells that lie side by side");
  }



  template <>
  void
  orient_cells<3>(Mesh<3> &mesh)
  {
    for (Cell &cell : mesh.cells)
      {
        auto              volumes = corner_volumes(mesh, cell);
        const std::size_t n_negative =
          std::count_if(volumes.begin(),
                        volumes.end(),
                        [](const double volume) { return volume < 0.; });
        if (2 * n_negative > volumes.size())
          {
            if (is_simplex(mesh.cell_type))
              std::swap(cell.vertices[2], cell.vertices[3]);
            else
              std::swap_ranges(cell.vertices.begin(),
                               cell.vertices.begin() + 4,
                               cell.vertices.begin() + 4);
            volumes = corner_volumes(mesh, cell);
          }
        const double least =
          least_volume * std::pow(longest_distance(mesh, cell), 3);
        if (*std::max_element(volumes.begin(), volumes.end()) <= least)
          throw InputError("the cell at " + place(center_of(mesh, cell)) +
                           " has no volume; allowed are cells whose corners "
                           "don't lie in a plane");
        if (*std::min_element(volumes.begin(), volumes.end()) <= least)
          throw InputError("the cell at " + place(center_of(mesh, cell)) +
                           " is turned inside out at a corner; allowed are "
                           "hexahedra whose three edges at each corner point "
                           "into the cell");
      }
  }
} // namespace Sandglass
