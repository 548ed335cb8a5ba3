#include <deal.II/base/exceptions.h>

#include <sandglass/choices/dimensions.h>
#include <sandglass/scene/mesh.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>

namespace Sandglass
{
  namespace
  {
    constexpr unsigned int unused = static_cast<unsigned int>(-1);

    /// Place on a Morton curve of a cell of a regular grid: the bits of its
    /// coordinates by turns, as many as 64 bits hold of each.
    template <int dim>
    std::uint64_t
    morton_key(const std::array<std::uint32_t, dim> &coordinates)
    {
      std::uint64_t key = 0;
      for (unsigned int bit = 0; bit < 64 / dim; ++bit)
        for (unsigned int d = 0; d < dim; ++d)
          if (bit < 32 && (coordinates[d] >> bit & 1u) != 0)
            key |= std::uint64_t(1) << (dim * bit + d);
      return key;
    }



    /// Renumber the vertices in the order in which the cells meet them; returns
    /// the index that each has had.
    template <int dim>
    std::vector<unsigned int>
    number_vertices_by_cell(Mesh<dim> &mesh)
    {
      std::vector<unsigned int>       new_index(mesh.vertices.size(), unused);
      std::vector<unsigned int>       old_indices;
      std::vector<dealii::Point<dim>> vertices;
      for (auto &cell : mesh.cells)
        for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
          {
            unsigned int &index = new_index[cell.vertices[v]];
            if (index == unused)
              {
                index = vertices.size();
                vertices.push_back(mesh.vertices[cell.vertices[v]]);
                old_indices.push_back(cell.vertices[v]);
              }
            cell.vertices[v] = index;
          }

      std::vector<typename Mesh<dim>::Face> faces;
      for (typename Mesh<dim>::Face face : mesh.faces)
        {
          bool remains = true;
          for (unsigned int v = 0; v < mesh.vertices_per_face(); ++v)
            {
              face.vertices[v] = new_index[face.vertices[v]];
              remains          = remains && face.vertices[v] != unused;
            }
          if (remains)
            faces.push_back(face);
        }
      mesh.vertices = std::move(vertices);
      mesh.faces    = std::move(faces);
      return old_indices;
    }
  } // namespace



  template <int dim>
  MeshPart<dim>
  filled_part(const Mesh<dim> &mesh)
  {
    MeshPart<dim> part{mesh, {}, {}};
    part.mesh.cells.clear();
    for (unsigned int i = 0; i < mesh.cells.size(); ++i)
      if (mesh.cells[i].is_filled)
        {
          part.mesh.cells.push_back(mesh.cells[i]);
          part.cells.push_back(i);
        }
    part.vertices = number_vertices_by_cell(part.mesh);
    return part;
  }



  template <int dim>
  void
  sort_along_curve(Mesh<dim> &mesh)
  {
    // Vertices that no cell has don't count: they may be anywhere.
    number_vertices_by_cell(mesh);
    dealii::Point<dim> lower = mesh.vertices.at(0), upper = lower;
    for (const auto &vertex : mesh.vertices)
      for (unsigned int d = 0; d < dim; ++d)
        {
          lower[d] = std::min(lower[d], vertex[d]);
          upper[d] = std::max(upper[d], vertex[d]);
        }
    double extent = 0.;
    for (unsigned int d = 0; d < dim; ++d)
      extent = std::max(extent, upper[d] - lower[d]);

    std::vector<std::uint64_t> keys;
    keys.reserve(mesh.cells.size());
    for (const auto &cell : mesh.cells)
      {
        dealii::Tensor<1, dim> center;
        for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
          center += (mesh.vertices[cell.vertices[v]] - lower) /
                    (extent * mesh.vertices_per_cell());
        constexpr double               resolution = 1 << 20;
        std::array<std::uint32_t, dim> coordinates;
        for (unsigned int d = 0; d < dim; ++d)
          coordinates[d] = static_cast<std::uint32_t>(center[d] * resolution);
        keys.push_back(morton_key<dim>(coordinates));
      }

    std::vector<unsigned int> order(mesh.cells.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(),
                     order.end(),
                     [&keys](const unsigned int a, const unsigned int b) {
                       return keys[a] < keys[b];
                     });

    std::vector<typename Mesh<dim>::Cell> cells;
    cells.reserve(mesh.cells.size());
    for (const unsigned int i : order)
      cells.push_back(mesh.cells[i]);
    mesh.cells = std::move(cells);
    number_vertices_by_cell(mesh);
  }



#define INSTANTIATE(dim)                                      \
  template MeshPart<dim> filled_part<dim>(const Mesh<dim> &); \
  template void          sort_along_curve<dim>(Mesh<dim> &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
