#include <sandglass/flow/updated_lagrangian/rezoning/smooth_surface.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_mesh.h>

#include <cmath>

namespace Sandglass
{
  namespace
  {
    constexpr unsigned int most_sweeps = 20;



    double
    turn_between(const BoundaryPiece &first, const BoundaryPiece &second)
    {
      const Tensor<1, 2> arriving = derivative_on_curve(first.curve, 1.);
      const Tensor<1, 2> leaving  = derivative_on_curve(second.curve, 0.);
      return std::abs(std::atan2(cross(arriving, leaving), arriving * leaving));
    }



    /// Let three pieces that follow each other become straight; false where
    /// they end where they have begun.
    bool
    smooth(BoundaryPiece &a, BoundaryPiece &b, BoundaryPiece &c)
    {
      const Point<2>     start = a.curve[0], end = c.curve[1];
      const Tensor<1, 2> chord  = end - start;
      const double       length = chord.norm();
      double             area = 0., way = 0.;
      for (const BoundaryPiece *piece : {&a, &b, &c})
        {
          area += swept_area(piece->curve, start);
          way += piece->curve[0].distance(piece->curve[1]);
        }
      // A trapezium of two thirds of the chord, to the right of it.
      const double height = 1.5 * area / length;
      if (!(length > 0.3 * way) || !(std::abs(height) < length))
        return false;
      const Tensor<1, 2> right({chord[1] / length, -chord[0] / length});
      const Point<2>     first  = start + chord / 3. + height * right;
      const Point<2>     second = start + 2. * chord / 3. + height * right;
      a.curve                   = straight_curve(start, first);
      b.curve                   = straight_curve(first, second);
      c.curve                   = straight_curve(second, end);
      return true;
    }
  } // namespace



  unsigned int
  smooth_surface(BoundaryLoop &loop, const double largest_turn)
  {
    const auto at = [&loop](const unsigned int i) -> BoundaryPiece & {
      return loop[i % loop.size()];
    };
    const auto is_free = [&at](const unsigned int i) {
      return at(i).mark == TriangleMesh::free_surface;
    };
    unsigned int       n_smoothed = 0;
    const unsigned int n          = loop.size();
    if (n < 6)
      return 0;
    for (unsigned int sweep = 0; sweep < most_sweeps; ++sweep)
      {
        const unsigned int n_before = n_smoothed;
        for (unsigned int i = 0; i < n; ++i)
          {
            if (!is_free(i) || !is_free(i + 1) ||
                turn_between(at(i), at(i + 1)) <= largest_turn)
              continue;
            // The third piece comes before and after by turns.
            const bool   is_even = sweep % 2 == 0;
            bool         is_done = false;
            unsigned int first   = is_even ? i : i + n - 1;
            for (unsigned int way = 0; way < 2 && !is_done; ++way)
              {
                if (is_free(first) && is_free(first + 1) && is_free(first + 2))
                  is_done = smooth(at(first), at(first + 1), at(first + 2));
                first = is_even ? i + n - 1 : i;
              }
            n_smoothed += is_done;
          }
        if (n_smoothed == n_before)
          break;
      }
    return n_smoothed;
  }
} // namespace Sandglass
