#include <sandglass/observers/flow_rate.h>

#include <algorithm>
#include <iterator>
#include <limits>

namespace Sandglass
{
  FlowRate::FlowRate(const double window)
    : window(window)
  {}



  void
  FlowRate::add(const double time, const double discharged_mass)
  {
    samples.push_back({time, discharged_mass});
  }



  double
  FlowRate::current() const
  {
    if (samples.size() < 2)
      return 0.;
    const Sample &now = samples.back();
    // A sample one window old counts although rounding may make it younger.
    const double youngest_start = now.time - window * (1. - 1e-6);

    auto start = std::prev(samples.end(), 2);
    while (start != samples.begin() && start->time > youngest_start)
      --start;
    return (now.mass - start->mass) / (now.time - start->time);
  }



  double
  FlowRate::plateau() const
  {
    const double mass = samples.empty() ? 0. : samples.back().mass;
    if (mass <= 0.)
      return std::numeric_limits<double>::quiet_NaN();
    return 0.5 * mass / (time_of(0.75 * mass) - time_of(0.25 * mass));
  }



  double
  FlowRate::time_of(const double mass) const
  {
    const auto after = std::find_if(samples.begin(),
                                    samples.end(),
                                    [mass](const Sample &sample) {
                                      return sample.mass >= mass;
                                    });
    if (after == samples.begin())
      return after->time;
    const auto before = std::prev(after);
    return before->time + (after->time - before->time) * (mass - before->mass) /
                            (after->mass - before->mass);
  }
} // namespace Sandglass
