#ifndef sandglass_flow_updated_lagrangian_rezoning_triangle_mesh_h
#define sandglass_flow_updated_lagrangian_rezoning_triangle_mesh_h

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <array>
#include <functional>
#include <vector>

namespace Sandglass
{
  using namespace dealii;

  /**
   * Triangles with three or six nodes, in their deformed places.
   *
   * A cell's nodes are its corners, counter-clockwise, and in order 2 the nodes
   * on its edges 0-1, 1-2 and 2-0. This is the order of FE_SimplexP<2> and of
   * Gmsh's types 2 and 9 alike, so that nothing has to be reordered.
   */
  struct TriangleMesh
  {
    /// The mark of an edge that lies on no wall; equal to `no_wall`.
    static constexpr unsigned int free_surface = numbers::invalid_unsigned_int;

    /// An edge at which the material ends.
    struct BoundaryEdge
    {
      unsigned int cell;
      unsigned int edge; ///< of the cell, as listed above
      /// The wall it lies on, or `free_surface`.
      unsigned int mark;
    };

    using Cell = std::array<unsigned int, 6>;

    unsigned int          order = 2; ///< 1: three nodes, 2: six nodes
    std::vector<Point<2>> nodes;     ///< in m
    /// Indices of nodes; in order 1 only the first three are used.
    std::vector<Cell>         cells;
    std::vector<BoundaryEdge> boundary;
    /// Of each cell, the body it belongs to. Cells that share an edge belong to
    /// one body; bodies are numbered from 0.
    std::vector<unsigned int> bodies;

    unsigned int
    n_nodes_per_cell() const
    {
      return 3 * order;
    }

    unsigned int
    n_bodies() const;

    /// Start, end and middle of an edge, along which the cell lies to the left.
    /// In order 1 the middle is half way.
    std::array<Point<2>, 3>
    edge_points(const unsigned int cell, const unsigned int edge) const;

    /// The nodes there, in this order; in order 1 start and end only.
    std::vector<unsigned int>
    edge_nodes(const unsigned int cell, const unsigned int edge) const;
  };

  /// Give the cells of a mesh of order 2, which have corners, nodes half way
  /// along their edges.
  void
  add_edge_nodes(TriangleMesh &mesh);

  /// Of each node, the body of the first of its cells, or invalid_unsigned_int.
  std::vector<unsigned int>
  bodies_of_nodes(const TriangleMesh &mesh);

  /// Of each cell, the cells beyond its edges, or invalid_unsigned_int.
  std::vector<std::array<unsigned int, 3>>
  neighbours_of_cells(const TriangleMesh &mesh);

  /**
   * Fill `boundary` and `bodies` from the cells.
   *
   * @param mark_of  the mark of the edge of a cell.
   */
  void
  find_boundary(
    TriangleMesh                                               &mesh,
    const std::function<unsigned int(const unsigned int cell,
                                     const unsigned int edge)> &mark_of);
} // namespace Sandglass

#endif
