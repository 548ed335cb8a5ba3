#ifndef sandglass_output_section_vertical_part_h
#define sandglass_output_section_vertical_part_h

#include <sandglass/flow/flow_view.h>
#include <sandglass/scene/scene.h>

#include <limits>
#include <optional>
#include <vector>

namespace Sandglass
{
  /**
   * What formulas for silos presume, as far as a section has it: gravity that
   * points down, a level surface, and from there down vertical walls, the same
   * distance apart and with nothing between them, that end above a flat bottom
   * or a plain hopper. Lengths in m.
   *
   * A thousandth of the width counts as rounding.
   */
  class VerticalPart
  {
  public:
    explicit VerticalPart(const Scene<2> &scene);

    /// Distance of the walls in the whole silo; 0 if there is no such part.
    double width = 0.;
    /// Area over perimeter of its cross section.
    double hydraulic_radius = 0.;
    /// Where it begins and ends: at the surface, and where one of its walls
    /// ends or anything stands between them.
    double top = 0., foot = 0.;

    /// tan(friction angle) of its walls; none where they differ or move.
    std::optional<double> friction_coefficient;

    bool has_flat_bottom = false;
    /// Whether all its walls end at its foot, no step is below it, and it has
    /// no core.
    bool is_plain = false;

    /// Tangent of the angle between hopper and vertical; NaN unless the hopper
    /// begins at the foot, has this angle and one friction all over, and
    /// contains nothing.
    double hopper_slope = std::numeric_limits<double>::quiet_NaN();
    /// tan(friction angle) of the hopper; none without one.
    std::optional<double> hopper_friction_coefficient;

    /// Distance between the middles of outlet and walls; 0 without outlet,
    /// infinite with several.
    double outlet_eccentricity = 0.;

    /// Whether a wall's node and face are among its walls.
    bool
    has_wall(const WallRecord &record) const;
    /// Whether they are its flat bottom.
    bool
    has_bottom(const WallRecord &record) const;
    /// Whether they are the hopper that begins at its foot.
    bool
    has_hopper(const WallRecord &record) const;

  private:
    /// An edge of a wall that holds material, from below upwards.
    struct Edge
    {
      Point<2> lower, upper;
      WallId   wall;
    };

    void
    find_sides(const Scene<2> &scene, const std::vector<Point<2>> &points);
    void
    find_foot(const std::vector<Edge> &edges);
    void
    find_hopper(const Scene<2> &scene, const std::vector<Edge> &edges);
    void
    find_outlet(const Scene<2> &scene);

    bool
    is_side(const double x) const;
    bool
    is_part_of_side(const Edge &edge) const;

    double rounding = 0.;
    /// x of the walls.
    std::vector<double> sides;
    /// x of the axis.
    std::optional<double> axis;
    /// Lowest point of the material.
    double bottom = 0.;
  };
} // namespace Sandglass

#endif
