#ifndef sandglass_flow_updated_lagrangian_motion_check_new_mesh_h
#define sandglass_flow_updated_lagrangian_motion_check_new_mesh_h

#include <sandglass/base/exceptions.h>
#include <sandglass/flow/updated_lagrangian/rezoning/rezone.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /// Where the boundary of a new mesh would cross itself.
  struct Crossing : RunError
  {
    Crossing(const std::string &message, const Point<2> &place)
      : RunError(message)
      , place(place)
    {}

    Point<2> place; ///< in m
  };

  /// Throws Crossing where the boundary of a mesh made anew would cross itself.
  void
  check_crossings(const TriangleMesh &mesh, const RezoningOptions &options);

  /// Straighten the edges of cells that walls or curved edges have turned over.
  /// Throws Crossing where that isn't enough.
  void
  check_cells(TriangleMesh &mesh);

  /// Throws RunError where a re-zoning has changed the material's area by more
  /// than a hundredth and by more than two elements: then its boundary was
  /// drawn wrongly.
  /// @param element_size  edge of the new elements in m.
  void
  check_area(const RezoningJumps &jumps, const double element_size);

  /// Mark the cells at the boundary that have a node nearer to a place than
  /// this distance in m as spoilt.
  void
  spoil_round(const TriangleMesh &mesh,
              const Point<2>     &place,
              const double        distance,
              std::vector<bool>  &is_spoilt);

  /// Mark cells at the free surface that are distorted beyond a bound, of the
  /// ratio of Jacobians and of the smallest angle in radians, as spoilt.
  void
  spoil_distorted(const TriangleMesh &mesh,
                  const double        smallest_quality,
                  std::vector<bool>  &is_spoilt);
} // namespace Sandglass

#endif
