#ifndef sandglass_scene_cell_type_h
#define sandglass_scene_cell_type_h

namespace Sandglass
{
  /// Shape of the grid's cells.
  enum class CellType
  {
    triangle,
    quadrilateral,
    tetrahedron,
    hexahedron
  };

  constexpr unsigned int
  vertices_per_cell(const CellType cell_type)
  {
    return cell_type == CellType::triangle   ? 3 :
           cell_type == CellType::hexahedron ? 8 :
                                               4;
  }

  /// Whether the cells are simplices, on which deal.II has elements of their
  /// own.
  constexpr bool
  is_simplex(const CellType cell_type)
  {
    return cell_type == CellType::triangle ||
           cell_type == CellType::tetrahedron;
  }

  /// Stands for a cell type as an argument of a function.
  template <CellType cell_type, int dim_>
  struct CellTypeTag
  {
    static constexpr CellType value = cell_type;
    static constexpr int      dim   = dim_;
  };
} // namespace Sandglass

#endif
