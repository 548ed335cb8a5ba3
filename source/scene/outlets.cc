#include <deal.II/base/types.h>

#include <sandglass/choices/dimensions.h>
#include <sandglass/scene/mesh_faces.h>
#include <sandglass/scene/outlets.h>

#include <algorithm>
#include <set>
#include <utility>

namespace Sandglass
{
  namespace
  {
    using Neighbors = std::vector<std::vector<unsigned int>>;

    /// The cells that hang together with one, itself included.
    std::vector<unsigned int>
    connected_cells(const unsigned int start,
                    const Neighbors   &neighbors,
                    std::vector<bool> &is_known)
    {
      std::vector<unsigned int> cells{start};
      is_known[start] = true;
      for (std::size_t next = 0; next < cells.size(); ++next)
        for (const unsigned int neighbor : neighbors[cells[next]])
          if (!is_known[neighbor])
            {
              is_known[neighbor] = true;
              cells.push_back(neighbor);
            }
      std::sort(cells.begin(), cells.end());
      return cells;
    }



    /// x and z of the middle of some cells, in m.
    template <int dim>
    std::pair<double, double>
    middle(const Mesh<dim> &mesh, const std::vector<unsigned int> &cells)
    {
      dealii::Tensor<1, dim> sum;
      for (const unsigned int cell : cells)
        for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
          sum += mesh.vertices[mesh.cells[cell].vertices[v]];
      sum /= cells.size() * mesh.vertices_per_cell();
      return {sum[0], dim == 3 ? sum[dim - 1] : 0.};
    }
  } // namespace



  template <int dim>
  std::vector<Outlet>
  find_outlets(const Mesh<dim> &mesh)
  {
    const bool is_closed =
      std::none_of(mesh.faces.begin(), mesh.faces.end(), [](const auto &face) {
        return is_open(face.role);
      });
    if (is_closed)
      return {};

    const CellsAtFaces<dim> cells_at = cells_at_faces(mesh);
    const unsigned int      n        = mesh.vertices_per_face();
    const auto              cells_of = [&](const auto &face) {
      const auto entry = cells_at.find(key_of<dim>(face.vertices, n));
      return entry == cells_at.end() ? std::vector<unsigned int>() :
                                                    entry->second;
    };
    std::set<FaceKey<dim>> openings;
    for (const auto &face : mesh.faces)
      if (face.role == BoundaryRole::outlet)
        openings.insert(key_of<dim>(face.vertices, n));
    Neighbors neighbors(mesh.cells.size());
    for (const auto &[face, cells] : cells_at)
      if (cells.size() == 2 && openings.count(face) == 0)
        {
          neighbors[cells[0]].push_back(cells[1]);
          neighbors[cells[1]].push_back(cells[0]);
        }

    std::vector<Outlet> outlets;
    std::vector<bool>   is_known(mesh.cells.size(), false);
    for (const auto &face : mesh.faces)
      if (is_open(face.role))
        for (const unsigned int cell : cells_of(face))
          if (!is_known[cell])
            outlets.push_back({connected_cells(cell, neighbors, is_known), {}});
    std::sort(outlets.begin(),
              outlets.end(),
              [&mesh](const Outlet &a, const Outlet &b) {
                return middle(mesh, a.cells) < middle(mesh, b.cells);
              });

    for (unsigned int i = 0; i < mesh.faces.size(); ++i)
      if (mesh.faces[i].role == BoundaryRole::outlet)
        for (const unsigned int cell : cells_of(mesh.faces[i]))
          for (Outlet &outlet : outlets)
            if (std::binary_search(outlet.cells.begin(),
                                   outlet.cells.end(),
                                   cell))
              outlet.faces.push_back(i);
    return outlets;
  }



  std::string
  name_of_outlet(const unsigned int index, const unsigned int n_outlets)
  {
    const std::string name(name_of(BoundaryRole::outlet));
    return n_outlets == 1 ? name : name + '_' + std::to_string(index + 1);
  }



#define INSTANTIATE(dim) \
  template std::vector<Outlet> find_outlets<dim>(const Mesh<dim> &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
