#include <sandglass/flow/updated_lagrangian/rezoning/boundary_piece.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  QuadraticCurve
  straight_curve(const Point<2> &start, const Point<2> &end)
  {
    return {{start, end, start + (end - start) / 2.}};
  }



  Point<2>
  position_on_curve(const QuadraticCurve &curve, const double t)
  {
    const auto &[start, end, middle] = curve;
    return Point<2>((1. - t) * (1. - 2. * t) * start + t * (2. * t - 1.) * end +
                    4. * t * (1. - t) * middle);
  }



  Tensor<1, 2>
  derivative_on_curve(const QuadraticCurve &curve, const double t)
  {
    const auto &[start, end, middle] = curve;
    return (4. * t - 3.) * start + (4. * t - 1.) * end + (4. - 8. * t) * middle;
  }



  QuadraticCurve
  part_of_curve(const QuadraticCurve &curve,
                const double          first,
                const double          last)
  {
    return {{position_on_curve(curve, first),
             position_on_curve(curve, last),
             position_on_curve(curve, (first + last) / 2.)}};
  }



  Point<2>
  bezier_corner(const QuadraticCurve &curve)
  {
    const auto &[start, end, middle] = curve;
    return Point<2>(2. * Tensor<1, 2>(middle) -
                    (start + Tensor<1, 2>(end)) / 2.);
  }



  double
  nearest_on_curve(const QuadraticCurve &curve, const Point<2> &p)
  {
    // The distance may have two minima: the best of some points is near the
    // lower one.
    constexpr unsigned int n_samples = 9;
    double                 nearest   = 0.;
    for (unsigned int i = 1; i < n_samples; ++i)
      {
        const double t = i / (n_samples - 1.);
        if (p.distance_square(position_on_curve(curve, t)) <
            p.distance_square(position_on_curve(curve, nearest)))
          nearest = t;
      }

    // Newton's method for (x(t) - p) x'(t) = 0.
    const Tensor<1, 2> second =
      4. * (curve[0] + (curve[1] - 2. * Tensor<1, 2>(curve[2])));
    for (unsigned int i = 0; i < 20; ++i)
      {
        const Tensor<1, 2> to_curve  = position_on_curve(curve, nearest) - p;
        const Tensor<1, 2> tangent   = derivative_on_curve(curve, nearest);
        const double       slope     = to_curve * tangent;
        const double       curvature = tangent * tangent + to_curve * second;
        if (!(curvature > 0.))
          break;
        const double next =
          std::min(std::max(nearest - slope / curvature, 0.), 1.);
        const bool is_converged = std::abs(next - nearest) < 1e-15;
        nearest                 = next;
        if (is_converged)
          break;
      }
    return nearest;
  }



  double
  bulge_area(const QuadraticCurve &curve)
  {
    const auto &[start, end, middle] = curve;
    const Tensor<1, 2> chord         = end - start;
    return 2. / 3. * cross(middle - (start + chord / 2.), chord);
  }



  double
  swept_area(const QuadraticCurve &curve, const Point<2> &origin)
  {
    return cross(curve[0] - origin, curve[1] - origin) / 2. + bulge_area(curve);
  }



  double
  enclosed_area(const BoundaryLoop &loop)
  {
    double area = 0.;
    for (const BoundaryPiece &piece : loop)
      area += swept_area(piece.curve, loop.front().curve[0]);
    return area;
  }
} // namespace Sandglass
