#include <sandglass/flow/updated_lagrangian/rezoning/boundary_piece.h>
#include <sandglass/flow/updated_lagrangian/rezoning/crossing.h>

#include <algorithm>

namespace Sandglass
{
  namespace
  {
    struct Side
    {
      Point<2> start, end;
    };

    bool
    share_a_corner(const Side &a, const Side &b)
    {
      return a.start == b.start || a.start == b.end || a.end == b.start ||
             a.end == b.end;
    }

    bool
    boxes_meet(const Side &a, const Side &b)
    {
      for (unsigned int d = 0; d < 2; ++d)
        if (std::max(a.start[d], a.end[d]) < std::min(b.start[d], b.end[d]) ||
            std::max(b.start[d], b.end[d]) < std::min(a.start[d], a.end[d]))
          return false;
      return true;
    }

    /// Whether b's ends lie on one side of a's line, and not on it.
    bool
    is_on_one_side(const Side &a, const Side &b)
    {
      const double start = cross(a.end - a.start, b.start - a.start);
      const double end   = cross(a.end - a.start, b.end - a.start);
      return (start > 0. && end > 0.) || (start < 0. && end < 0.);
    }

    /// Sides that share a corner meet elsewhere if they lie on each other.
    bool
    turns_back(const Side &a, const Side &b)
    {
      const Tensor<1, 2> u = a.end - a.start, v = b.end - b.start;
      return a.end == b.start && cross(u, v) == 0. && u * v < 0.;
    }
  } // namespace



  bool
  find_crossing(const std::vector<std::vector<Point<2>>> &loops,
                Point<2>                                 &place)
  {
    std::vector<Side> sides;
    for (const auto &loop : loops)
      for (unsigned int i = 0; i < loop.size(); ++i)
        sides.push_back({loop[i], loop[(i + 1) % loop.size()]});
    for (const Side &a : sides)
      for (const Side &b : sides)
        {
          if (&a == &b || !boxes_meet(a, b))
            continue;
          const bool is_crossing =
            share_a_corner(a, b) ?
              turns_back(a, b) :
              !is_on_one_side(a, b) && !is_on_one_side(b, a);
          if (is_crossing)
            {
              place = b.start;
              return true;
            }
        }
    return false;
  }
} // namespace Sandglass
