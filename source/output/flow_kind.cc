#include <sandglass/output/flow_kind.h>

#include <cmath>
#include <map>

namespace Sandglass
{
  const std::vector<Column<FlowLevel>> flow_profile_table = {
    {"side",
     "",
     [](const FlowLevel &l) { return l.side; },
     "of the outlet's middle, `left` or `right`; half a silo is its right side"},
    {"y_m",
     "m",
     [](const FlowLevel &l) { return l.y; },
     "middle of a band of heights, of which there are 32 up to the first "
     "surface"},
    {"wall_speed_m_per_s",
     "m/s",
     [](const FlowLevel &l) { return l.wall_speed; },
     "mean downwards speed of the material that is no farther from the wall "
     "than a twentieth of the silo's width; `nan` where there is none"},
    {"middle_speed_m_per_s",
     "m/s",
     [](const FlowLevel &l) { return l.middle_speed; },
     "likewise from the vertical through the outlet's middle"},
    {"mass_flow_index",
     "1",
     [](const FlowLevel &l) { return l.mass_flow_index(); },
     "the first over the second; below 0.3 the material beside the wall counts "
     "as standing"}};



  FlowKind::FlowKind(const std::vector<FlowLevel> &levels)
  {
    // Of each side's highest level that has one.
    std::map<std::string, double> index_at_surface;
    for (const FlowLevel &level : levels)
      {
        const double index = level.mass_flow_index();
        if (std::isnan(index))
          continue;
        index_at_surface[level.side] = index;
        if (!(index >= smallest_mass_flow_index))
          smallest_mass_flow_index = index;
        if (index < FlowLevel::mass_flow_limit && !(level.top <= transition))
          transition = level.top;
      }
    if (std::isnan(smallest_mass_flow_index))
      return;
    name = "mass flow";
    if (std::isnan(transition))
      return;
    name = "pipe flow";
    for (const auto &[side, index] : index_at_surface)
      if (index >= FlowLevel::mass_flow_limit)
        name = "mixed flow";
  }
} // namespace Sandglass
