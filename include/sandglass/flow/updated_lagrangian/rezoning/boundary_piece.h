#ifndef sandglass_flow_updated_lagrangian_rezoning_boundary_piece_h
#define sandglass_flow_updated_lagrangian_rezoning_boundary_piece_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace Sandglass
{
  using namespace dealii;

  /// Start, end and middle of a curve that is quadratic in its parameter t,
  /// 0 at the start, 1 at the end and 1/2 at the middle; in m.
  using QuadraticCurve = std::array<Point<2>, 3>;

  QuadraticCurve
  straight_curve(const Point<2> &start, const Point<2> &end);

  Point<2>
  position_on_curve(const QuadraticCurve &curve, const double t);

  /// dx/dt, in m.
  Tensor<1, 2>
  derivative_on_curve(const QuadraticCurve &curve, const double t);

  /// The part from t = `first` to t = `last`, which is the same curve.
  QuadraticCurve
  part_of_curve(const QuadraticCurve &curve,
                const double          first,
                const double          last);

  /// The inner corner of the curve's Bezier polygon. Where start, end and this
  /// point lie on one side of a line, so does the curve.
  Point<2>
  bezier_corner(const QuadraticCurve &curve);

  /// t of the curve's point that is nearest to `p`.
  double
  nearest_on_curve(const QuadraticCurve &curve, const Point<2> &p);

  /// Area in m^2 between a curve and the straight line from its start to its
  /// end; positive where the curve bulges to the right.
  double
  bulge_area(const QuadraticCurve &curve);

  /// Area in m^2 that the line from `origin` to the curve's point passes from
  /// start to end, counter-clockwise positive. Summed up over a closed sequence
  /// it is the area enclosed.
  double
  swept_area(const QuadraticCurve &curve, const Point<2> &origin = Point<2>());

  /// A piece of the material's boundary, with the material to its left.
  struct BoundaryPiece
  {
    QuadraticCurve curve;
    /// The wall it lies on, or TriangleMesh::free_surface.
    unsigned int mark;
    /// Whether its start has to stay where it is: a corner of the material, of
    /// a wall, or a change of mark.
    bool starts_at_corner;
  };

  /// Pieces that follow each other and close: round a body counter-clockwise,
  /// round a hole in it clockwise.
  using BoundaryLoop = std::vector<BoundaryPiece>;

  /// Area in m^2 that a loop encloses; of holes negative.
  double
  enclosed_area(const BoundaryLoop &loop);

  /// z component of the cross product.
  inline double
  cross(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
  {
    return a[0] * b[1] - a[1] * b[0];
  }
} // namespace Sandglass

#endif
