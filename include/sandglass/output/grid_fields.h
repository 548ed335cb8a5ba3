#ifndef sandglass_output_grid_fields_h
#define sandglass_output_grid_fields_h

#include <sandglass/base/table.h>
#include <sandglass/flow/flow_view.h>
#include <sandglass/output/vtu_file.h>

#include <vector>

namespace Sandglass
{
  /// Fields of grid.pvd at its nodes.
  extern const std::vector<Field<NodeRecord>> grid_node_table;

  /// Fields of grid.pvd in its cells.
  extern const std::vector<Field<CellRecord>> grid_cell_table;

  /**
   * This rank's cells. Collective.
   *
   * @param dim  of the cells.
   */
  VtuPiece
  grid_fields(const FlowView &view, const unsigned int dim);
} // namespace Sandglass

#endif
