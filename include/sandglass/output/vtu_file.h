#ifndef sandglass_output_vtu_file_h
#define sandglass_output_vtu_file_h

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace Sandglass
{
  /**
   * One rank's part of a picture for ParaView: points, cells of one kind, and
   * fields on them.
   */
  struct VtuPiece
  {
    /// Values of a field, point by point or cell by cell.
    struct Field
    {
      std::string  name;
      unsigned int n_components;
      std::variant<std::vector<float>,
                   std::vector<double>,
                   std::vector<std::int64_t>,
                   std::vector<std::int32_t>>
        values;
      /// One name for each component, or none.
      std::vector<std::string> component_names;
    };

    /// Names of a symmetric tensor's components in the order in which VTK and
    /// ParaView expect them.
    static const std::vector<std::string> symmetric_tensor_components;

    /// Three coordinates for each point, in m.
    std::vector<double> points;

    /// How many points a cell has, and how many dimensions: a dot, a line, a
    /// triangle of three or six, a quadrilateral, a tetrahedron or a
    /// hexahedron.
    unsigned int points_per_cell = 1;
    unsigned int cell_dimension  = 0;

    /// Indices of the cells' points, in VTK's order.
    std::vector<std::int32_t> cells;

    std::vector<Field> point_fields;
    std::vector<Field> cell_fields;
  };

  /// Write a piece as compressed .vtu. Throws RunError.
  void
  write_vtu(const std::string &filename, const VtuPiece &piece);

  /**
   * Write the .pvtu that joins pieces with the fields of `piece`.
   *
   * @param piece_names  files of the pieces, relative to the .pvtu.
   */
  void
  write_pvtu(const std::string              &filename,
             const VtuPiece                 &piece,
             const std::vector<std::string> &piece_names);
} // namespace Sandglass

#endif
