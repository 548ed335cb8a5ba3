#ifndef sandglass_scene_mesh_h
#define sandglass_scene_mesh_h

#include <deal.II/base/point.h>

#include <sandglass/base/setting.h>
#include <sandglass/scene/boundary_role.h>

#include <array>
#include <vector>

namespace Sandglass
{
  /**
   * Vertices, cells and named edges of the computational mesh, as Gmsh or a
   * test makes them, before deal.II turns them into a triangulation.
   */
  struct Mesh
  {
    struct Cell
    {
      /// Vertex indices, counterclockwise; the last is unused in triangles.
      std::array<unsigned int, 4> vertices;
      /// Whether material fills the cell at the start.
      bool is_filled;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &vertices &is_filled;
      }
    };

    struct Edge
    {
      std::array<unsigned int, 2> vertices;
      BoundaryRole                role;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &vertices &role;
      }
    };

    CellType                        cell_type = CellType::triangle;
    std::vector<dealii::Point<dim>> vertices; ///< in m
    std::vector<Cell>               cells;
    std::vector<Edge>               edges;

    unsigned int
    vertices_per_cell() const
    {
      return cell_type == CellType::triangle ? 3 : 4;
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &cell_type &vertices &cells &edges;
    }
  };

  /**
   * The part of `mesh` that material fills at the start, its cells in the same
   * order. Vertices that no filled cell uses are left out; edges are kept
   * where both vertices remain.
   *
   * @param[out] cell_indices  index in `mesh` of each cell of the result.
   */
  Mesh
  filled_part(const Mesh &mesh, std::vector<unsigned int> &cell_indices);

  /**
   * Sort cells and vertices along a space-filling (Morton) curve, so that
   * neighbours in space are neighbours in memory.
   */
  void
  sort_along_curve(Mesh &mesh);
} // namespace Sandglass

#endif
