#ifndef sandglass_particle_stage_cell_kernel_h
#define sandglass_particle_stage_cell_kernel_h

#include <sandglass/particle_stage/nodal_fields.h>
#include <sandglass/particles/cell_geometry.h>
#include <sandglass/particles/particle_cloud.h>

namespace Sandglass
{
  /// Values at the nodes of one cell, gathered from or to be added to a field.
  template <std::size_t n_components, std::size_t n_nodes>
  using CellValues = std::array<std::array<double, n_components>, n_nodes>;

  template <std::size_t n_components, std::size_t n_nodes>
  CellValues<n_components, n_nodes>
  gather(const NodalField<n_components>          &field,
         const std::array<unsigned int, n_nodes> &nodes)
  {
    CellValues<n_components, n_nodes> values;
    for (unsigned int i = 0; i < n_nodes; ++i)
      for (unsigned int c = 0; c < n_components; ++c)
        values[i][c] = field.at(nodes[i])[c];
    return values;
  }

  template <std::size_t n_components, std::size_t n_nodes>
  void
  scatter(const CellValues<n_components, n_nodes> &values,
          const std::array<unsigned int, n_nodes> &nodes,
          NodalField<n_components>                &field)
  {
    for (unsigned int i = 0; i < n_nodes; ++i)
      for (unsigned int c = 0; c < n_components; ++c)
        field.at(nodes[i])[c] += values[i][c];
  }

  /**
   * Call `kernel(cell index, shape, nodes, particles)` for each of this rank's
   * cells that holds particles.
   */
  template <CellType cell_type, typename Kernel>
  void
  for_each_filled_cell(ParticleCloud                 &cloud,
                       const CellGeometry<cell_type> &geometry,
                       const Kernel                  &kernel)
  {
    for (const auto &cell : cloud.owned_cells())
      {
        const auto particles = cloud.handler.particles_in_cell(cell);
        if (particles.begin() == particles.end())
          continue;
        const unsigned int index = cell->active_cell_index();
        kernel(index, geometry.shape(index), geometry.nodes(index), particles);
      }
  }
} // namespace Sandglass

#endif
