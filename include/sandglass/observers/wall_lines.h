#ifndef sandglass_observers_wall_lines_h
#define sandglass_observers_wall_lines_h

#include <sandglass/scene/mesh.h>

#include <array>
#include <map>
#include <vector>

namespace Sandglass
{
  using namespace dealii;

  /**
   * The silo's walls as lines along which lengths are measured: from their end
   * next to the middle of the silo's bottom, so that floors count outwards,
   * hoppers from the outlet upwards, and walls from their foot upwards. The
   * outlet counts as a wall, which it is while it is closed.
   */
  class WallLines
  {
  public:
    WallLines(const Mesh &mesh, const Point<dim> &bottom_centre);

    /// Where a vertex lies on the walls of one role.
    struct Place
    {
      /// Lines of a role are numbered by the distance of their start from the
      /// middle of the bottom.
      unsigned int line;
      double       arc_length; ///< in m
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

    /// From `vertex` on to its other neighbors, which are taken out.
    void
    follow_line(const Mesh        &mesh,
                const BoundaryRole role,
                unsigned int       vertex,
                const unsigned int line,
                Neighbors         &neighbors);

    /// Role and coordinates of a vertex.
    using Key = std::array<double, 3>;

    static Key
    key(const BoundaryRole role, const Point<dim> &vertex)
    {
      return {{static_cast<double>(role), vertex[0], vertex[1]}};
    }

    std::map<Key, Place> places;
  };
} // namespace Sandglass

#endif
