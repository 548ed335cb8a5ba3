#ifndef sandglass_scene_mesh_h
#define sandglass_scene_mesh_h

#include <deal.II/base/point.h>

#include <sandglass/scene/cell_type.h>
#include <sandglass/walls/boundary_role.h>

#include <array>
#include <string>
#include <vector>

namespace Sandglass
{
  /**
   * Vertices, cells and named faces of the computational mesh, as Gmsh or a
   * test makes them, before deal.II turns them into a triangulation.
   */
  template <int dim>
  struct Mesh
  {
    static constexpr unsigned int most_vertices_per_cell = 1u << dim;

    struct Cell
    {
      /// Vertex indices, counterclockwise; the last are unused in simplices.
      std::array<unsigned int, most_vertices_per_cell> vertices;
      /// Whether material fills the cell at the start.
      bool is_filled;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &vertices &is_filled;
      }
    };

    /// What `named_wall` is in faces of standard parts.
    static constexpr unsigned int standard_part = static_cast<unsigned int>(-1);

    struct Face
    {
      std::array<unsigned int, most_vertices_per_cell / 2> vertices;
      BoundaryRole                                         role;
      /// Index in `named_walls`, if it belongs to one of them.
      unsigned int named_wall = standard_part;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &vertices &role &named_wall;
      }

      /// Its id in triangulations.
      dealii::types::boundary_id
      boundary_id() const
      {
        return named_wall == standard_part ? Sandglass::boundary_id(role) :
                                             first_named_boundary + named_wall;
      }
    };

    CellType                        cell_type = CellType::triangle;
    std::vector<dealii::Point<dim>> vertices; ///< in m
    std::vector<Cell>               cells;
    std::vector<Face>               faces;
    /// Names of the walls beyond the standard parts.
    std::vector<std::string> named_walls;

    unsigned int
    vertices_per_cell() const
    {
      return Sandglass::vertices_per_cell(cell_type);
    }

    unsigned int
    vertices_per_face() const
    {
      return is_simplex(cell_type) ? dim : most_vertices_per_cell / 2;
    }

    /// The physical group's name in a mesh file.
    std::string
    name_of(const Face &face) const
    {
      return face.named_wall == standard_part ?
               std::string(Sandglass::name_of(face.role)) :
               named_walls[face.named_wall];
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &cell_type &vertices &cells &faces &named_walls;
    }
  };

  /// A part of a mesh as a mesh of its own.
  template <int dim>
  struct MeshPart
  {
    Mesh<dim> mesh;
    /// Index in the whole mesh of each cell and vertex.
    std::vector<unsigned int> cells, vertices;
  };

  /**
   * The part of `mesh` that material fills at the start, its cells in the same
   * order. Vertices that no filled cell uses are left out; faces are kept
   * where all their vertices remain.
   */
  template <int dim>
  MeshPart<dim>
  filled_part(const Mesh<dim> &mesh);

  /**
   * Sort cells and vertices along a space-filling (Morton) curve, so that
   * neighbours in space are neighbours in memory.
   */
  template <int dim>
  void
  sort_along_curve(Mesh<dim> &mesh);
} // namespace Sandglass

#endif
