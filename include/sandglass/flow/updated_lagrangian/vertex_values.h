#ifndef sandglass_flow_updated_lagrangian_vertex_values_h
#define sandglass_flow_updated_lagrangian_vertex_values_h

#include <sandglass/flow/updated_lagrangian/element_grid.h>

#include <vector>

namespace Sandglass
{
  /**
   * A nodal vector field vertex by vertex, which is the same on any number of
   * ranks; on each rank. Collective.
   */
  template <int dim>
  std::vector<double>
  values_at_vertices(const ElementGrid<dim>   &grid,
                     const DisplacementVector &vector);

  /// The same back as a vector with ghost entries.
  template <int dim>
  DisplacementVector
  vector_of_values(const ElementGrid<dim>    &grid,
                   const std::vector<double> &values_at_vertices);
} // namespace Sandglass

#endif
