#ifndef sandglass_flow_updated_lagrangian_motion_rigid_walls_h
#define sandglass_flow_updated_lagrangian_motion_rigid_walls_h

#include <sandglass/scene/scene.h>

#include <array>
#include <vector>

namespace Sandglass
{
  /**
   * A straight part of a wall or of the axis: neighbouring edges of one wall
   * and one direction. It runs from start to end with the material to its left.
   */
  struct RigidWall
  {
    WallId       wall; ///< no_wall: the axis
    Point<2>     start, end;
    Tensor<1, 2> normal;  ///< outward from the material, unit length
    Tensor<1, 2> tangent; ///< from start to end, unit length
    double       friction_coefficient = 0.;
    /// Whether start and end are corners round which the material can pass: the
    /// lip, the top. At others another wall holds it.
    std::array<bool, 2> is_free_end = {{true, true}};

    /// The axis holds what comes to it for ever, and has no ends.
    bool
    is_axis() const
    {
      return wall == no_wall;
    }

    double
    length() const
    {
      return start.distance(end);
    }

    /// How far a point has passed the wall's line, in m.
    double
    gap(const Point<2> &p) const
    {
      return normal * (p - start);
    }

    /// Of the angle by which another wall's direction differs.
    double
    sine_to(const RigidWall &other) const
    {
      return normal[0] * other.normal[1] - normal[1] * other.normal[0];
    }

    /// Whether a point's foot on the line lies on the wall; at ends that are
    /// not free also beyond, where the next wall holds it.
    bool
    reaches(const Point<2> &p) const;
  };

  /// All walls of a section and its axis, without open boundaries.
  std::vector<RigidWall>
  find_rigid_walls(const Scene<2> &scene);

  /// Corners of walls that point into the material, in m: the lip, and where a
  /// wall turns away from it.
  std::vector<Point<2>>
  rigid_corners(const Scene<2> &scene, const std::vector<RigidWall> &walls);

  /// All ends of walls but those on the axis, in m.
  std::vector<Point<2>>
  wall_ends(const std::vector<RigidWall> &walls);
} // namespace Sandglass

#endif
