#include <sandglass/output/largest_pressure.h>

namespace Sandglass
{
  void
  LargestPressure::add(const std::vector<WallTraction> &tractions,
                       const bool                       outlet_opens)
  {
    for (const WallTraction &traction : tractions)
      {
        if (!(traction.normal() > pressure) ||
            (outlet_opens && traction.role == BoundaryRole::outlet))
          continue;
        pressure = traction.normal();
        time     = traction.time;
        x        = traction.record.position[0];
        y        = traction.record.position[1];
        wall     = traction.wall_name;
        eurocode = traction.eurocode_discharge.normal;
        janssen  = traction.janssen_normal;
      }
  }
} // namespace Sandglass
