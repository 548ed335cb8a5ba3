#ifndef sandglass_output_wall_lines_h
#define sandglass_output_wall_lines_h

#include <sandglass/scene/mesh.h>

#include <array>
#include <map>
#include <string_view>
#include <vector>

namespace Sandglass
{
  using namespace dealii;

  /**
   * The silo's walls as lines along which lengths are measured: from their end
   * next to the middle of the outlet, so that floors count outwards, hoppers
   * from the outlet upwards, and walls from their foot upwards. The outlet
   * counts as a wall, which it is while it is closed. Of two ends or lines
   * equally near, the left one comes first.
   */
  class WallLines
  {
  public:
    WallLines(const Mesh &mesh, const Point<dim> &bottom_centre);

    /// Which side of the outlet's middle a whole line lies on.
    enum class Side
    {
      left   = -1,
      middle = 0, ///< on both sides
      right  = 1
    };

    /// Where a vertex lies on the walls of one role.
    struct Place
    {
      /// Lines of a role are numbered by the distance of their start from the
      /// middle of the outlet.
      unsigned int line;
      double       arc_length; ///< in m
      Side         side;
    };

    /// The vertex must have an edge with this role.
    const Place &
    find(const BoundaryRole role, const Point<dim> &vertex) const;

  private:
    /// Vertices that edges of one role connect with each vertex.
    using Neighbors = std::map<unsigned int, std::vector<unsigned int>>;

    void
    add_lines(const Mesh        &mesh,
              const BoundaryRole role,
              const Point<dim>  &bottom_centre);

    /// From `vertex` on to its other neighbors, which are taken out; the
    /// vertices of the line, in order.
    static std::vector<unsigned int>
    follow_line(unsigned int vertex, Neighbors &neighbors);

    /// Role and coordinates of a vertex.
    using Key = std::array<double, 3>;

    static Key
    key(const BoundaryRole role, const Point<dim> &vertex)
    {
      return {{static_cast<double>(role), vertex[0], vertex[1]}};
    }

    std::map<Key, Place> places;
  };

  /// The side's name: `left`, `middle` or `right`.
  std::string_view
  name_of(const WallLines::Side side);
} // namespace Sandglass

#endif
