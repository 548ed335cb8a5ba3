#include <sandglass/output/field_collector.h>
#include <sandglass/output/grid_fields.h>

namespace Sandglass
{
  const std::vector<Field<NodeRecord>> grid_node_table = {
    {"mass",
     "kg",
     [](const NodeRecord &node) { return static_cast<float>(node.mass); },
     "of the material around the node; in plane strain per metre of depth"},
    {"velocity",
     "m/s",
     [](const NodeRecord &node) { return node.velocity; },
     "of the last step, with which the particles have moved"}};



  const std::vector<Field<CellRecord>> grid_cell_table = {
    {"number of particles",
     "1",
     [](const CellRecord &cell) { return cell.n_particles; },
     "in the cell"},
    {"subdomain",
     "1",
     [](const CellRecord &cell) { return cell.subdomain; },
     "rank that owns the cell"}};



  VtuPiece
  grid_fields(const FlowView &view, const unsigned int dim)
  {
    GridRecords grid = view.grid();

    VtuPiece piece;
    piece.points_per_cell = grid.nodes_per_cell;
    piece.cell_dimension  = dim;
    piece.cells           = std::move(grid.nodes_of_cells);

    FieldCollector<NodeRecord> node_fields(grid_node_table, grid.nodes.size());
    piece.points.reserve(3 * grid.nodes.size());
    for (const NodeRecord &node : grid.nodes)
      {
        for (unsigned int d = 0; d < 3; ++d)
          piece.points.push_back(node.location[d]);
        node_fields.add(node);
      }
    piece.point_fields = node_fields.take();

    FieldCollector<CellRecord> cell_fields(grid_cell_table, grid.cells.size());
    for (const CellRecord &cell : grid.cells)
      cell_fields.add(cell);
    piece.cell_fields = cell_fields.take();
    return piece;
  }
} // namespace Sandglass
