#ifndef sandglass_flow_updated_lagrangian_rezoning_size_field_h
#define sandglass_flow_updated_lagrangian_rezoning_size_field_h

#include <deal.II/base/point.h>

#include <algorithm>
#include <vector>

namespace Sandglass
{
  using namespace dealii;

  /// How long the edges of a new mesh are to be.
  struct SizeField
  {
    /// A point round which edges are shorter.
    struct Centre
    {
      Point<2> position; ///< in m
      double   size;     ///< of edges there, in m
      /// By how much edges are longer with each m of distance. At 0.2
      /// neighbouring edges differ by a fifth, so triangles stay good.
      double growth = 0.2;
    };

    double              size;         ///< far from the centres, in m
    std::vector<Centre> centres = {}; ///< the lip, for instance

    /// Length of an edge at a point, in m.
    double
    at(const Point<2> &p) const
    {
      double result = size;
      for (const Centre &centre : centres)
        result =
          std::min(result,
                   centre.size + centre.growth * p.distance(centre.position));
      return result;
    }
  };
} // namespace Sandglass

#endif
