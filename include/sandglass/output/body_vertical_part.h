#ifndef sandglass_output_body_vertical_part_h
#define sandglass_output_body_vertical_part_h

#include <sandglass/flow/flow_view.h>
#include <sandglass/scene/scene.h>

#include <limits>
#include <optional>

namespace Sandglass
{
  /**
   * What formulas for silos presume, as far as a body has it: gravity that
   * points down, a level surface, and from there down vertical walls around
   * the same cross section with nothing in it, that end above a flat bottom or
   * a plain hopper. Lengths in m, of the whole silo.
   */
  class BodyVerticalPart
  {
  public:
    explicit BodyVerticalPart(const Scene<3> &scene);

    /// Smallest width of the cross section (of a circle its diameter); 0 if
    /// there is no such part.
    double width = 0.;
    /// Area over perimeter of the cross section.
    double hydraulic_radius = 0.;
    /// Where it begins and ends: at the surface, and where its walls end.
    double top = 0., foot = 0.;

    /// tan(friction angle) of its walls; none where they differ or move.
    std::optional<double> friction_coefficient;

    bool has_flat_bottom = false;

    /// Tangent of the angle between hopper and vertical; NaN unless the hopper
    /// has this angle and one friction all over.
    double hopper_slope = std::numeric_limits<double>::quiet_NaN();
    /// Whether the hopper narrows in one direction only.
    bool hopper_is_wedge = false;
    /// tan(friction angle) of the hopper; none without one.
    std::optional<double> hopper_friction_coefficient;

    /// Distance between the middles of outlet and cross section; 0 without
    /// outlet.
    double outlet_eccentricity = 0.;

    /// Whether a wall's node and face are among its walls.
    bool
    has_wall(const WallRecord &record) const;
    /// Whether they are its flat bottom.
    bool
    has_bottom(const WallRecord &record) const;
    /// Whether they are the hopper.
    bool
    has_hopper(const WallRecord &record) const;

  private:
    /// A face of a wall that holds material.
    struct Face
    {
      Tensor<1, 3> normal; ///< outward
      double       area;
      double       lower, upper; ///< y
      WallId       wall;
    };

    static std::vector<Face>
    wall_faces(const Scene<3> &scene);
    /// Whether the walls' area is that of the cross section's perimeter from
    /// foot to top: then nothing stands in between.
    void
    find_cross_section(const Scene<3> &scene, const std::vector<Face> &faces);
    void
    find_hopper(const Scene<3> &scene, const std::vector<Face> &faces);

    double rounding = 0.;
  };
} // namespace Sandglass

#endif
