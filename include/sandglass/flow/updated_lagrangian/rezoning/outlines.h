#ifndef sandglass_flow_updated_lagrangian_rezoning_outlines_h
#define sandglass_flow_updated_lagrangian_rezoning_outlines_h

#include <sandglass/flow/updated_lagrangian/rezoning/boundary_piece.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_mesh.h>

#include <functional>
#include <vector>

namespace Sandglass
{
  /// Which points of a boundary a new mesh has to keep.
  struct CornerRule
  {
    /// Radians by which the boundary's direction may change where there is no
    /// corner.
    double largest_turn = 0.5;
    /// Points of rigid corners, in m: kinks of walls, the lip.
    std::vector<Point<2>> fixed_points = {};
    /// How far in m the boundary may pass from such a point and still be held
    /// to run through it.
    double tolerance = 1e-9;
    /// The mark of a piece once it has been divided at fixed points, as edges
    /// that reach beyond a wall's end are; empty: that of the edge.
    std::function<unsigned int(const BoundaryPiece &)> mark_of = {};
    /// What else is to be changed in a loop before all this; empty: nothing.
    std::function<void(BoundaryLoop &)> change = {};
  };

  /// What bounds one body.
  struct BodyOutline
  {
    BoundaryLoop              outside;
    std::vector<BoundaryLoop> holes = {};

    /// In m^2.
    double
    area() const;
  };

  /**
   * The outlines of a mesh's bodies, in their order: every edge at which the
   * material ends, as it is curved. Where a body touches itself or another one
   * in a node, the loops follow the material.
   *
   * Corners are where the direction turns by more than the rule allows, where
   * the mark changes, where boundaries touch, and at fixed points; a piece that
   * runs through a fixed point is divided there. Throws RunError for a mesh
   * whose bodies enclose no area.
   */
  std::vector<BodyOutline>
  find_outlines(const TriangleMesh &mesh, const CornerRule &rule);
} // namespace Sandglass

#endif
