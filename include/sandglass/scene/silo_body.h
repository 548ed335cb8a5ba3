#ifndef sandglass_scene_silo_body_h
#define sandglass_scene_silo_body_h

#include <sandglass/scene/outline.h>
#include <sandglass/scene/scene_parameters.h>

#include <array>

namespace Sandglass
{
  /**
   * A silo in three dimensions, as its parameters describe it: a vertical wall
   * over `wall`, below it a floor or a hopper that narrows to `outlet` along
   * straight lines, and the fall region below the outlet, at y = 0. Lengths in
   * m. The middle of the silo is at x = z = 0.
   */
  struct SiloBody
  {
    explicit SiloBody(const SceneParameters &parameters);

    Outline wall, outlet;
    /// Whether the outlet goes from wall to wall along z, which leaves lips
    /// along z only.
    bool   outlet_is_slot;
    double hopper_height, silo_height, fall_region_depth;

    /// Whether the planes x = 0 and z = 0 are symmetry planes, at which the
    /// mesh ends.
    std::array<bool, 2> ends_at_plane;

    bool
    has_hopper() const
    {
      return hopper_height > 0.;
    }

    /// What part of the silo is meshed: 1, 1/2 or 1/4.
    double
    meshed_share() const
    {
      return (ends_at_plane[0] ? 0.5 : 1.) * (ends_at_plane[1] ? 0.5 : 1.);
    }

    /// Volume of all material in the whole silo, in m^3; of a hopper that
    /// changes its shape, about.
    double
    filled_volume() const;

    /// Distance of a point (x, y, z) from the outlet's lip, in m.
    double
    distance_from_lip(const dealii::Point<3> &point) const;

    /**
     * Where a point of the square (see Outline) lies at a height: on its border
     * on the silo's walls, which in a hopper are straight lines from the outlet
     * to the wall above.
     */
    dealii::Point<3>
    at(const dealii::Point<2> &of_square, const double y) const;

    /// Coordinates that are closer than this are the same, in m.
    double
    rounding() const
    {
      return 1e-7 * wall.half_width;
    }
  };
} // namespace Sandglass

#endif
