#include <sandglass/flow/particle_in_cell/overfull_cells.h>

#include <algorithm>

namespace Sandglass
{
  bool
  relieves_overfull_cells(const ParticleStageParameters &parameters,
                          const FeedParameters          &feed)
  {
    switch (parameters.relieve_overfull_cells)
      {
        case RelieveOverfullCells::never:
          return false;
        case RelieveOverfullCells::where_fed:
          return feed.kind != FeedKind::none;
        default:
          return true;
      }
  }



  double
  relief_rate(const double filling, const double side, const double gravity)
  {
    // Particles come one by one, so their number in a few cells fluctuates, in
    // flow as at rest. What is allowed keeps that from loosening what flows.
    constexpr double allowed = 0.1;
    // Of the time in which a cell's length is passed in the flow's
    // acceleration.
    constexpr double relative_time = 5.;
    return std::max(0., filling - 1. - allowed) * std::sqrt(gravity / side) /
           relative_time;
  }
} // namespace Sandglass
