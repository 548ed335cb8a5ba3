#include <sandglass/choices/dimensions.h>
#include <sandglass/scene/feed_cells.h>
#include <sandglass/scene/fill_layers.h>
#include <sandglass/scene/mesh_faces.h>
#include <sandglass/scene/section_surface_nodes.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace Sandglass
{
  template <int dim>
  FillLayers<dim>::FillLayers(const Mesh<dim>   &mesh,
                              const unsigned int n_layers)
    : n_layers(n_layers)
    , mesh(mesh)
    , bottom(std::numeric_limits<double>::max())
    , top(std::numeric_limits<double>::lowest())
  {
    for (const auto &cell : mesh.cells)
      if (cell.is_filled)
        for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
          {
            const double y = mesh.vertices[cell.vertices[v]][1];
            bottom         = std::min(bottom, y);
            top            = std::max(top, y);
          }
  }



  template <int dim>
  unsigned int
  FillLayers<dim>::layer_of(const unsigned int cell) const
  {
    const double height = middle_of_cell(mesh, cell)[1] - bottom;
    const double layer  = std::floor(n_layers * height / (top - bottom));
    return static_cast<unsigned int>(std::clamp(layer, 0., n_layers - 1.));
  }



  template <int dim>
  double
  FillLayers<dim>::top_of(const unsigned int layer) const
  {
    return bottom + (top - bottom) * (layer + 1.) / n_layers;
  }



  template <int dim>
  void
  fit_layers(Mesh<dim> &mesh, const unsigned int n_layers)
  {
    if constexpr (dim == 2)
      for (unsigned int layer = 0; layer + 1 < n_layers; ++layer)
        {
          const FillLayers<dim>  layers(mesh, n_layers);
          std::set<unsigned int> nodes;
          for (const auto &[vertices, cells] : cells_at_faces(mesh))
            if (cells.size() == 2 && mesh.cells[cells[0]].is_filled &&
                mesh.cells[cells[1]].is_filled &&
                (layers.layer_of(cells[0]) <= layer) !=
                  (layers.layer_of(cells[1]) <= layer))
              nodes.insert(vertices.begin(), vertices.end());
          // A heap's surface and the outlet stay where they are.
          for (const auto &face : mesh.faces)
            if (face.role == BoundaryRole::top ||
                face.role == BoundaryRole::outlet)
              for (const unsigned int vertex : face.vertices)
                nodes.erase(vertex);
          const double level = layers.top_of(layer);
          move_surface_nodes(mesh, nodes, [level](const double) {
            return level;
          });
        }
  }



  template <int dim>
  Mesh<dim>
  fill_layers(const Mesh<dim>       &mesh,
              const FillLayers<dim> &layers,
              const unsigned int     n_filled)
  {
    Mesh<dim> result = mesh;
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      result.cells[cell].is_filled =
        mesh.cells[cell].is_filled && layers.layer_of(cell) < n_filled;
    for (const auto &[vertices, cells] : cells_at_faces(mesh))
      if (cells.size() == 2 && mesh.cells[cells[0]].is_filled &&
          mesh.cells[cells[1]].is_filled &&
          result.cells[cells[0]].is_filled != result.cells[cells[1]].is_filled)
        result.faces.push_back({vertices, BoundaryRole::top});
    return result;
  }



#define INSTANTIATE(dim)                                               \
  template class FillLayers<dim>;                                      \
  template void      fit_layers<dim>(Mesh<dim> &, const unsigned int); \
  template Mesh<dim> fill_layers<dim>(const Mesh<dim> &,               \
                                      const FillLayers<dim> &,         \
                                      const unsigned int);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
