#ifndef sandglass_output_section_wall_lines_h
#define sandglass_output_section_wall_lines_h

#include <sandglass/scene/mesh.h>
#include <sandglass/walls/wall.h>

#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace Sandglass
{
  using namespace dealii;

  /**
   * The walls of a section as lines along which lengths are measured: from
   * their end next to the middle of the outlet, so that floors count outwards,
   * hoppers from the outlet upwards, and walls from their foot upwards. The
   * outlet counts as a wall, which it is while it is closed. Of two ends or
   * lines equally near, the left one comes first.
   */
  class WallLines
  {
  public:
    WallLines(const Mesh<2>              &mesh,
              const std::vector<Wall<2>> &walls,
              const Point<2>             &bottom_centre);

    /// Which side of the outlet's middle a whole line lies on.
    enum class Side
    {
      left   = -1,
      middle = 0, ///< on both sides
      right  = 1
    };

    /// Where a vertex lies on one wall.
    struct Place
    {
      /// Lines of a wall are numbered by the distance of their start from the
      /// middle of the outlet.
      unsigned int line;
      double       arc_length; ///< in m
      Side         side;
    };

    /// @param vertex  of the mesh; it must have an edge of this wall.
    const Place &
    find(const WallId wall, const unsigned int vertex) const;

  private:
    /// Vertices that edges of one wall connect with each vertex.
    using Neighbors = std::map<unsigned int, std::vector<unsigned int>>;

    void
    add_lines(const Mesh<2>  &mesh,
              const WallId    wall,
              Neighbors      &neighbors,
              const Point<2> &bottom_centre);

    /// The vertices of the line from `vertex` on, in order; each is taken out
    /// of `neighbors`.
    static std::vector<unsigned int>
    follow_line(unsigned int vertex, Neighbors &neighbors);

    std::map<std::pair<WallId, unsigned int>, Place> places;
  };

  /// The side's name: `left`, `middle` or `right`.
  std::string_view
  name_of(const WallLines::Side side);
} // namespace Sandglass

#endif
