#include <sandglass/base/exceptions.h>
#include <sandglass/scene/mesh_cells.h>

#include <algorithm>
#include <set>

namespace Sandglass
{
  namespace
  {
    /// Twice the area of a triangle of vertices counted counterclockwise.
    double
    cross_product(const dealii::Point<2> &a,
                  const dealii::Point<2> &b,
                  const dealii::Point<2> &c)
    {
      return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    }
  } // namespace



  template <>
  void
  check_overlap<2>(const Mesh<2> &mesh)
  {
    // Counterclockwise cells that share an edge go along it to either side.
    std::set<std::pair<unsigned int, unsigned int>> edges;
    const unsigned int n = mesh.vertices_per_cell();
    for (const auto &cell : mesh.cells)
      for (unsigned int v = 0; v < n; ++v)
        if (const auto start = cell.vertices[v],
            end              = cell.vertices[(v + 1) % n];
            !edges.emplace(start, end).second)
          throw InputError("two cells overlap: they lie on the same side of "
                           "the edge from " +
                           place(mesh.vertices[start]) + " to " +
                           place(mesh.vertices[end]) +
                           "; allowed are cells that lie side by side");
  }



  template <>
  void
  orient_cells<2>(Mesh<2> &mesh)
  {
    // Of the square of the longest edge. Cells thinner than that have no
    // meaningful derivatives.
    constexpr double least_area = 1e-9;

    const unsigned int n = mesh.vertices_per_cell();
    for (auto &cell : mesh.cells)
      {
        const auto vertex = [&](const unsigned int v) -> const auto &
        {
          return mesh.vertices[cell.vertices[v % n]];
        };
        double           area = 0., longest_square = 0.;
        dealii::Point<2> center;
        for (unsigned int v = 0; v < n; ++v)
          {
            area += cross_product(vertex(0), vertex(v), vertex(v + 1));
            longest_square =
              std::max(longest_square,
                       (vertex(v + 1) - vertex(v)).norm_square());
            center += vertex(v) / n;
          }
        if (area < 0.)
          std::reverse(cell.vertices.begin() + 1, cell.vertices.begin() + n);

        double least_corner = std::abs(area);
        for (unsigned int v = 0; v < n; ++v)
          least_corner =
            std::min(least_corner,
                     cross_product(vertex(v), vertex(v + 1), vertex(v + 2)));
        if (std::abs(area) <= least_area * longest_square)
          throw InputError("the cell at " + place(center) +
                           " has no area; allowed are cells whose corners "
                           "don't lie on a line");
        if (least_corner <= least_area * longest_square)
          throw InputError("the cell at " + place(center) +
                           " is not convex; allowed are quadrilaterals whose "
                           "inner angles are all less than 180 degrees");
      }
  }
} // namespace Sandglass
