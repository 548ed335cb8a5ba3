#include <sandglass/study/smallest_outlet.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Sandglass
{
  const std::vector<Column<OutletTrial>> smallest_outlet_table = {
    {"outlet_half_width_m",
     "m",
     [](const OutletTrial &trial) { return trial.half_width; },
     "half the width or the radius; also in the name of the run's directory"},
    {"flows",
     "1",
     [](const OutletTrial &trial) {
       return static_cast<unsigned long>(trial.flows);
     },
     "1 if material still flows towards the end of the run, 0 if it stands"},
    {"flow_rate_kg_per_s",
     "kg/s",
     [](const OutletTrial &trial) { return trial.flow_rate; },
     "mean over the last third of the run"}};



  const std::vector<Column<SmallestOutlet>> smallest_outlet_summary_table = {
    {"status",
     "",
     [](const SmallestOutlet &s) { return s.status; },
     "`running`, which a study that was killed stays; `finished`, `failed`, or "
     "`stopped` by a signal"},
    {"message",
     "",
     [](const SmallestOutlet &s) { return s.message; },
     "of the error that ended the study",
     [](const SmallestOutlet &s) { return !s.message.empty(); }},
    {"largest_arrested_half_width_m",
     "m",
     [](const SmallestOutlet &s) { return s.largest_arrested(); },
     "widest outlet in which the material stands; `null` if it flows in all"},
    {"smallest_flowing_half_width_m",
     "m",
     [](const SmallestOutlet &s) { return s.smallest_flowing(); },
     "narrowest one above that in which it flows; `null` if it flows in none"},
    {"unconfined_strength_Pa",
     "Pa",
     [](const SmallestOutlet &s) { return s.unconfined_strength; },
     "2 c cos φ / (1 − sin φ), which does not depend on consolidation"},
    {"jenike_flow_factor",
     "1",
     [](const SmallestOutlet &s) { return s.flow_factor; },
     "of the hopper by the radial stress field; `null` without one"},
    {"jenike_outlet_width_m",
     "m",
     [](const SmallestOutlet &s) { return s.arching_width; },
     "width of a slot or diameter of a round outlet above which no arch "
     "stands"},
    {"jenike_rathole_diameter_m",
     "m",
     [](const SmallestOutlet &s) { return s.rathole_diameter; },
     "above which no pipe stands in funnel flow"},
    {"jenike_mass_flow_limit_degrees",
     "degrees",
     [](const SmallestOutlet &s) { return s.mass_flow_limit; },
     "largest angle of a cone's wall from the vertical with mass flow"}};



  double
  SmallestOutlet::largest_arrested() const
  {
    double largest = std::numeric_limits<double>::quiet_NaN();
    for (const OutletTrial &trial : trials)
      if (!trial.flows && !(trial.half_width <= largest))
        largest = trial.half_width;
    return largest;
  }



  double
  SmallestOutlet::smallest_flowing() const
  {
    const double arrested = largest_arrested();
    double       smallest = std::numeric_limits<double>::quiet_NaN();
    for (const OutletTrial &trial : trials)
      if (trial.flows && !(trial.half_width <= arrested) &&
          !(trial.half_width >= smallest))
        smallest = trial.half_width;
    return smallest;
  }
} // namespace Sandglass
