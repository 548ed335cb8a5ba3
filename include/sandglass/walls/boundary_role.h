#ifndef sandglass_walls_boundary_role_h
#define sandglass_walls_boundary_role_h

#include <deal.II/base/types.h>

#include <array>
#include <string_view>

namespace Sandglass
{
  /**
   * What a face of the mesh is for the silo. Inner faces without a role don't
   * appear.
   *
   * The outlet is an inner face while a fall region lies below it, and a
   * boundary face of the filled region and of a closed silo.
   */
  enum class BoundaryRole : dealii::types::boundary_id
  {
    /// Symmetry axis or plane x = 0: no normal velocity, no friction.
    axis = 1,
    /// Vertical wall of the silo.
    wall = 2,
    /// Horizontal bottom beside the outlet.
    floor = 3,
    /// Inclined wall of the hopper.
    hopper = 4,
    /// Level at which discharged material is counted.
    outlet = 5,
    /// Side of the fall region: particles that pass it are removed.
    fall_side = 6,
    /// Bottom of the fall region: particles that pass it are removed.
    fall_bottom = 7,
    /// Top of the silo: no particle may pass it.
    top = 8,
    /// Wall under another name whose faces have several directions.
    insert = 9
  };

  /**
   * Names of the standard parts of a boundary: the physical group's name in a
   * mesh file for each role but the insert, in order of value.
   */
  inline constexpr std::array<std::string_view, 8> boundary_role_names = {
    {"axis",
     "wall",
     "floor",
     "hopper",
     "outlet",
     "fall_side",
     "fall_bottom",
     "top"}};

  constexpr std::string_view
  name_of(const BoundaryRole role)
  {
    return role == BoundaryRole::insert ?
             "insert" :
             boundary_role_names[static_cast<unsigned int>(role) - 1];
  }

  /// The id that triangulations give the faces of a standard part.
  constexpr dealii::types::boundary_id
  boundary_id(const BoundaryRole role)
  {
    return static_cast<dealii::types::boundary_id>(role);
  }

  /// The id that they give the faces of the first wall under another name; the
  /// next has the next id.
  inline constexpr dealii::types::boundary_id first_named_boundary = 16;

  /// Whether the face holds material back with friction while it is closed.
  constexpr bool
  is_wall(const BoundaryRole role)
  {
    return role == BoundaryRole::wall || role == BoundaryRole::floor ||
           role == BoundaryRole::hopper || role == BoundaryRole::outlet ||
           role == BoundaryRole::insert;
  }

  /// Whether a particle that passes the face is discharged and removed.
  constexpr bool
  is_open(const BoundaryRole role)
  {
    return role == BoundaryRole::fall_side || role == BoundaryRole::fall_bottom;
  }
} // namespace Sandglass

#endif
