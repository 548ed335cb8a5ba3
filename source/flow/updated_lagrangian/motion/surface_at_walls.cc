#include <sandglass/flow/updated_lagrangian/motion/mesh_walls.h>
#include <sandglass/flow/updated_lagrangian/motion/surface_at_walls.h>
#include <sandglass/flow/updated_lagrangian/rezoning/outlines.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  namespace
  {
    // Over the length of an element.

    /// As much of the surface may be straightened.
    constexpr double longest_piece = 4.;
    /// What ends sooner on a wall is a gap between material and wall.
    constexpr double shortest_surface = 6.;
    /// At a free end this near the surface leaves the wall as it likes.
    constexpr double near_free_end = 1.;



    /// A loop with material to the right, so that what ends at a wall begins
    /// there.
    void
    turn_round(BoundaryLoop &loop)
    {
      std::reverse(loop.begin(), loop.end());
      for (BoundaryPiece &piece : loop)
        std::swap(piece.curve[0], piece.curve[1]);
    }



    /**
     * The place where a loop leaves a wall: its first piece is free, and its
     * last one lies on the wall.
     */
    class SurfaceAtWall
    {
    public:
      /// @param side  1 where the material is to the left, else -1.
      SurfaceAtWall(BoundaryLoop        &loop,
                    const RigidWall     &wall,
                    const double         side,
                    const MotionSetting &setting)
        : loop(loop)
        , setting(setting)
        , wall(wall)
        , mark(loop.back().mark)
        , side(side)
        , h(setting.element_size)
        , contact(loop.front().curve[0])
        , along(side * wall.tangent)
      {}

      /// Returns whether the surface has been turned.
      bool
      turn(const double smallest_angle)
      {
        if (is_near_free_end() || is_gap() ||
            is_large_enough(derivative_on_curve(loop.front().curve, 0.),
                            smallest_angle))
          return false;
        double area = 0., length = 0.;
        for (unsigned int i = 0;
             i + 1 < loop.size() && loop[i].mark == TriangleMesh::free_surface;
             ++i)
          {
            const QuadraticCurve &curve = loop[i].curve;
            area += side * swept_area(curve, contact);
            length += curve[0].distance(curve[1]);
            if (length > longest_piece * h)
              return false;
            const Tensor<1, 2> way   = curve[1] - contact;
            const double       depth = side * cross(along, way);
            if (!(depth > 0.05 * h))
              continue;
            const double   shift = 2. * area / depth;
            const Point<2> moved = contact + shift * along;
            if (!is_large_enough(curve[1] - moved, smallest_angle) ||
                std::abs(shift) > longest_piece * h || !move_wall_to(moved))
              continue;
            const Point<2> end = curve[1];
            loop.erase(loop.begin(), loop.begin() + i + 1);
            loop.insert(loop.begin(),
                        BoundaryPiece{straight_curve(moved, end),
                                      TriangleMesh::free_surface,
                                      false});
            return true;
          }
        return false;
      }

    private:
      bool
      is_near_free_end() const
      {
        return !wall.is_axis() &&
               ((wall.is_free_end[0] &&
                 contact.distance(wall.start) < near_free_end * h) ||
                (wall.is_free_end[1] &&
                 contact.distance(wall.end) < near_free_end * h));
      }

      /// Whether this is no surface that spans the silo.
      bool
      is_gap() const
      {
        double      length = 0.;
        std::size_t i      = 0;
        for (; i < loop.size() && loop[i].mark == TriangleMesh::free_surface;
             ++i)
          length += loop[i].curve[0].distance(loop[i].curve[1]);
        const unsigned int end = loop[i % loop.size()].mark;
        return end == mark ||
               (!setting.walls[end].is_axis() && !wall.is_axis() &&
                length < shortest_surface * h);
      }

      /// Of the angles in the material and in the gap.
      bool
      is_large_enough(const Tensor<1, 2> &direction,
                      const double        smallest_angle) const
      {
        const double angle =
          std::atan2(side * cross(along, direction), along * direction);
        return angle >= smallest_angle && angle <= numbers::PI - smallest_angle;
      }

      /// Let the part on the wall end elsewhere; false where it can't.
      bool
      move_wall_to(const Point<2> &moved)
      {
        const double place = wall.tangent * (moved - wall.start);
        if (!wall.is_axis() && (place < 0. || place > wall.length()))
          return false;
        if ((moved - contact) * along >= 0.)
          {
            loop.push_back({straight_curve(contact, moved), mark, false});
            return true;
          }
        std::size_t n = loop.size();
        while (n > 1 && loop[n - 1].mark == mark &&
               (loop[n - 1].curve[0] - moved) * along >= 0.)
          --n;
        if (n <= 1 || loop[n - 1].mark != mark)
          return false;
        loop.resize(n);
        const Point<2> start = loop.back().curve[0];
        loop.back()          = {straight_curve(start, moved), mark, false};
        return true;
      }

      BoundaryLoop        &loop;
      const MotionSetting &setting;
      const RigidWall     &wall;
      const unsigned int   mark;
      const double         side, h;
      const Point<2>       contact;
      const Tensor<1, 2>   along; ///< from the part on the wall to the contact
    };



    unsigned int
    turn_where_it_leaves(BoundaryLoop        &loop,
                         const double         side,
                         const SurfaceAngles &smallest,
                         const MotionSetting &setting)
    {
      unsigned int n_turned = 0;
      for (std::size_t i = 0; i < loop.size(); ++i)
        {
          std::rotate(loop.begin(), loop.begin() + 1, loop.end());
          const unsigned int mark = loop.back().mark;
          if (loop.front().mark != TriangleMesh::free_surface ||
              mark == TriangleMesh::free_surface)
            continue;
          const RigidWall &wall = setting.walls[mark];
          n_turned +=
            SurfaceAtWall(loop, wall, side, setting)
              .turn(wall.is_axis() ? smallest.at_axis : smallest.at_walls);
        }
      return n_turned;
    }
  } // namespace



  unsigned int
  turn_surface_to_walls(BoundaryLoop        &loop,
                        const SurfaceAngles &smallest,
                        const MotionSetting &setting)
  {
    for (BoundaryPiece &piece : loop)
      piece.mark = wall_of(piece.curve, setting);
    unsigned int n = turn_where_it_leaves(loop, 1., smallest, setting);
    turn_round(loop);
    n += turn_where_it_leaves(loop, -1., smallest, setting);
    turn_round(loop);
    return n;
  }



  bool
  surface_leans_on_walls(const TriangleMesh  &mesh,
                         const SurfaceAngles &smallest,
                         const MotionSetting &setting)
  {
    for (const BodyOutline &outline : find_outlines(mesh, CornerRule()))
      {
        BoundaryLoop loop = outline.outside;
        if (turn_surface_to_walls(loop, smallest, setting) > 0)
          return true;
      }
    return false;
  }
} // namespace Sandglass
