#include <sandglass/output/flow_rate.h>

#include <algorithm>
#include <deque>
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



  std::size_t
  FlowRate::window_start(const std::size_t sample) const
  {
    // A sample one window old counts although rounding may make it younger.
    const double youngest_start = samples[sample].time - window * (1. - 1e-6);

    std::size_t start = sample - 1;
    while (start > 0 && samples[start].time > youngest_start)
      --start;
    return start;
  }



  double
  FlowRate::rate(const std::size_t start, const std::size_t end) const
  {
    return (samples[end].mass - samples[start].mass) /
           (samples[end].time - samples[start].time);
  }



  double
  FlowRate::current() const
  {
    if (samples.size() < 2)
      return 0.;
    const std::size_t now = samples.size() - 1;
    return rate(window_start(now), now);
  }



  double
  FlowRate::plateau() const
  {
    const double mass = samples.empty() ? 0. : samples.back().mass;
    return 0.5 * mass / (time_of_share(0.75) - time_of_share(0.25));
  }



  double
  FlowRate::mean(const double start, const double end) const
  {
    // Of a time that is the sum of many steps.
    constexpr double rounding = 1e-9;
    if (samples.empty() || samples.front().time > start ||
        samples.back().time < end * (1. - rounding))
      return std::numeric_limits<double>::quiet_NaN();
    return (mass_at(end) - mass_at(start)) / (end - start);
  }



  double
  FlowRate::interpolate(const double Sample::*known,
                        const double          value,
                        const double Sample::*wanted) const
  {
    const auto after =
      std::find_if(samples.begin(), samples.end(), [&](const Sample &sample) {
        return sample.*known >= value;
      });
    if (after == samples.end())
      return samples.back().*wanted;
    if (after == samples.begin())
      return (*after).*wanted;
    const Sample &next = *after, &last = *std::prev(after);
    return last.*wanted + (next.*wanted - last.*wanted) *
                            (value - last.*known) / (next.*known - last.*known);
  }



  double
  FlowRate::mass_at(const double time) const
  {
    return interpolate(&Sample::time, time, &Sample::mass);
  }



  double
  FlowRate::time_of_share(const double share) const
  {
    const double mass = samples.empty() ? 0. : samples.back().mass;
    return mass > 0. ? time_of(share * mass) :
                       std::numeric_limits<double>::quiet_NaN();
  }



  SteadyFlow
  FlowRate::steady() const
  {
    constexpr double deviation = 0.1;

    // Indices that may still become the largest or smallest rate of a stretch,
    // in order, the current largest or smallest at the front.
    std::deque<std::size_t> largest, smallest;
    std::vector<double>     rates(samples.size(), 0.);
    SteadyFlow              longest;
    std::size_t             first = 1;
    for (std::size_t i = 1; i < samples.size(); ++i)
      {
        rates[i] = rate(window_start(i), i);
        while (!largest.empty() && rates[largest.back()] <= rates[i])
          largest.pop_back();
        while (!smallest.empty() && rates[smallest.back()] >= rates[i])
          smallest.pop_back();
        largest.push_back(i);
        smallest.push_back(i);
        for (; first <= i; ++first)
          {
            if (largest.front() < first)
              largest.pop_front();
            if (smallest.front() < first)
              smallest.pop_front();
            const double top    = rates[largest.front()];
            const double bottom = rates[smallest.front()];
            if (bottom > 0. && top - bottom <= deviation * (top + bottom))
              break;
          }
        if (first > i)
          continue;
        const std::size_t start = window_start(first);
        // False for NaN, when there is none yet.
        if (!(samples[i].time - samples[start].time <=
              longest.end - longest.start))
          longest = {samples[start].time, samples[i].time, rate(start, i)};
      }
    return longest;
  }



  double
  FlowRate::spread(const double start) const
  {
    double smallest = std::numeric_limits<double>::infinity(), largest = 0.;
    for (std::size_t i = samples.size() - 1;
         i > 0 && i < samples.size() && samples[i].time >= start;
         --i)
      {
        const double of_window = rate(window_start(i), i);
        smallest               = std::min(smallest, of_window);
        largest                = std::max(largest, of_window);
      }
    return samples.empty() || samples.front().time > start || smallest <= 0. ?
             std::numeric_limits<double>::infinity() :
             (largest - smallest) / (largest + smallest);
  }



  double
  FlowRate::discharge_time() const
  {
    const double time = time_of_share(0.999);
    return !samples.empty() && samples.back().time - time >= window ?
             time :
             std::numeric_limits<double>::quiet_NaN();
  }



  double
  FlowRate::time_of(const double mass) const
  {
    return interpolate(&Sample::mass, mass, &Sample::time);
  }
} // namespace Sandglass
