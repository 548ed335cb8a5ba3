#include <sandglass/flow/particle_in_cell/overfull_cells.h>

#include <algorithm>

namespace Sandglass
{
  bool
  relieves_overfull_cells(const ParticleStageParameters &parameters,
                          const FeedParameters          &feed,
                          const bool is_in_unequal_hexahedra,
                          const bool has_open_outlet)
  {
    switch (parameters.relieve_overfull_cells)
      {
        case RelieveOverfullCells::never:
          return false;
        case RelieveOverfullCells::where_fed:
          return has_open_outlet && feed.kind == FeedKind::level;
        case RelieveOverfullCells::automatic:
          return has_open_outlet &&
                 (feed.kind == FeedKind::level || is_in_unequal_hexahedra);
        default:
          return true;
      }
  }



  double
  relief_rate(const double filling, const double side, const double gravity)
  {
    // Particles come one by one, so what a few cells hold fluctuates: what is
    // allowed keeps that from loosening material that flows.
    constexpr double allowed = 0.1;
    // Over sqrt(side / g), in which gravity brings a particle half a cell on.
    constexpr double relative_time = 6.;
    return std::max(0., filling - 1. - allowed) * std::sqrt(gravity / side) /
           relative_time;
  }
} // namespace Sandglass
