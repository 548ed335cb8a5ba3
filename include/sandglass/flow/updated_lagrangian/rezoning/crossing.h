#ifndef sandglass_flow_updated_lagrangian_rezoning_crossing_h
#define sandglass_flow_updated_lagrangian_rezoning_crossing_h

#include <deal.II/base/point.h>

#include <vector>

namespace Sandglass
{
  using namespace dealii;

  /**
   * Look for a place where sides of closed polygons cross or touch, other than
   * in a corner that they share.
   *
   * @return whether there is one; `place`, in m, is then near it.
   */
  bool
  find_crossing(const std::vector<std::vector<Point<2>>> &loops,
                Point<2>                                 &place);
} // namespace Sandglass

#endif
