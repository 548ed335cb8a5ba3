#ifndef sandglass_output_body_wall_parts_h
#define sandglass_output_body_wall_parts_h

#include <sandglass/flow/flow_view.h>
#include <sandglass/output/silo_measures.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /**
   * The walls of a body in parts: each side of a wall that has a few plane ones
   * is a part, and a wall that goes round is one. A part is cut into bands of
   * about a cell's height, on floors of about its width around the outlet.
   */
  class BodyWallParts
  {
  public:
    explicit BodyWallParts(const Scene<3> &scene);

    struct Part
    {
      WallId wall;
      /// `right`, `left`, `front` or `back` by the direction in which it faces
      /// away from the material, x, -x, z or -z; `around` if it has no such
      /// one.
      std::string side;
      /// Outward, of a plane side; zero where it goes round.
      Tensor<1, 3> normal;
      bool         is_floor;
      /// Where it begins, as a height or as a distance from the middle of the
      /// outlet, and how long it is, in m.
      double begin, length;
      /// Length along the wall over that.
      double       slant;
      unsigned int n_bands;
    };

    const std::vector<Part> &
    all() const
    {
      return parts;
    }

    /// The part to which a record belongs.
    unsigned int
    part_of(const WallRecord &record) const;

    /// Number of its band, from the outlet on.
    unsigned int
    band_of(const unsigned int part, const Point<3> &position) const;

    /// How far along its part, from where this begins, in m.
    double
    arc_length(const unsigned int part, const Point<3> &position) const;

    /// Horizontal distance from the middle of the outlet, of a slot from its
    /// middle line, in m.
    double
    distance_from_middle(const Point<3> &position) const;

    /// Along the wall: upwards, or on floors away from the outlet's middle.
    Tensor<1, 3>
    tangent(const WallRecord &record) const;

  private:
    double
    coordinate(const Part &part, const Point<3> &position) const
    {
      return part.is_floor ? distance_from_middle(position) : position[1];
    }

    const Point<3>    middle;
    const bool        has_slot;
    std::vector<Part> parts;
  };
} // namespace Sandglass

#endif
