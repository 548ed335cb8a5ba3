#include <deal.II/base/exceptions.h>

#include <sandglass/scene/mesh.h>

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace Sandglass
{
  namespace
  {
    constexpr unsigned int unused = static_cast<unsigned int>(-1);

    /// Spread the low 32 bits of `value` to the even bits of the result.
    std::uint64_t
    spread_bits(std::uint64_t value)
    {
      value &= 0xffffffffu;
      value = (value | (value << 16)) & 0x0000ffff0000ffffu;
      value = (value | (value << 8)) & 0x00ff00ff00ff00ffu;
      value = (value | (value << 4)) & 0x0f0f0f0f0f0f0f0fu;
      value = (value | (value << 2)) & 0x3333333333333333u;
      value = (value | (value << 1)) & 0x5555555555555555u;
      return value;
    }

    /// Renumber the vertices in the order in which the cells meet them.
    void
    number_vertices_by_cell(Mesh &mesh)
    {
      std::vector<unsigned int>       new_index(mesh.vertices.size(), unused);
      std::vector<dealii::Point<dim>> vertices;
      for (auto &cell : mesh.cells)
        for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
          {
            unsigned int &index = new_index[cell.vertices[v]];
            if (index == unused)
              {
                index = vertices.size();
                vertices.push_back(mesh.vertices[cell.vertices[v]]);
              }
            cell.vertices[v] = index;
          }

      std::vector<Mesh::Edge> edges;
      for (Mesh::Edge edge : mesh.edges)
        {
          for (unsigned int &vertex : edge.vertices)
            vertex = new_index[vertex];
          if (edge.vertices[0] != unused && edge.vertices[1] != unused)
            edges.push_back(edge);
        }
      mesh.vertices = std::move(vertices);
      mesh.edges    = std::move(edges);
    }
  } // namespace



  Mesh
  filled_part(const Mesh &mesh, std::vector<unsigned int> &cell_indices)
  {
    Mesh part = mesh;
    part.cells.clear();
    cell_indices.clear();
    for (unsigned int i = 0; i < mesh.cells.size(); ++i)
      if (mesh.cells[i].is_filled)
        {
          part.cells.push_back(mesh.cells[i]);
          cell_indices.push_back(i);
        }
    number_vertices_by_cell(part);
    return part;
  }



  void
  sort_along_curve(Mesh &mesh)
  {
    dealii::Point<dim> lower = mesh.vertices.at(0), upper = lower;
    for (const auto &vertex : mesh.vertices)
      for (unsigned int d = 0; d < dim; ++d)
        {
          lower[d] = std::min(lower[d], vertex[d]);
          upper[d] = std::max(upper[d], vertex[d]);
        }
    const double extent = std::max(upper[0] - lower[0], upper[1] - lower[1]);

    std::vector<std::uint64_t> keys;
    keys.reserve(mesh.cells.size());
    for (const auto &cell : mesh.cells)
      {
        dealii::Tensor<1, dim> center;
        for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
          center += (mesh.vertices[cell.vertices[v]] - lower) /
                    (extent * mesh.vertices_per_cell());
        constexpr double resolution = 1 << 20;
        keys.push_back(
          spread_bits(static_cast<std::uint64_t>(center[0] * resolution)) |
          spread_bits(static_cast<std::uint64_t>(center[1] * resolution)) << 1);
      }

    std::vector<unsigned int> order(mesh.cells.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(),
                     order.end(),
                     [&keys](const unsigned int a, const unsigned int b) {
                       return keys[a] < keys[b];
                     });

    std::vector<Mesh::Cell> cells;
    cells.reserve(mesh.cells.size());
    for (const unsigned int i : order)
      cells.push_back(mesh.cells[i]);
    mesh.cells = std::move(cells);
    number_vertices_by_cell(mesh);
  }
} // namespace Sandglass
