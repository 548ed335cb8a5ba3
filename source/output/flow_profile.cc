#include <deal.II/base/mpi.h>

#include <sandglass/output/flow_profile.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  FlowProfile::FlowProfile(const std::vector<FlowBand> &bands)
    : bands(bands)
    , of_rank(2 * n_places * bands.size(), 0.)
    , sums(of_rank)
  {}



  void
  FlowProfile::add(const ParticleRecord &particle)
  {
    const double x = particle.location[0], y = particle.location[1];
    if (bands.empty() || y < bands.front().lower || y >= bands.back().upper)
      return;
    const double height = bands.front().upper - bands.front().lower;
    const auto band = std::min<std::size_t>((y - bands.front().lower) / height,
                                            bands.size() - 1);
    const FlowBand &at    = bands[band];
    const auto      count = [&](const unsigned int place, const double where) {
      if (!(std::abs(x - where) <= at.reach))
        return;
      of_rank[index(band, place)] += particle.mass;
      of_rank[index(band, place) + 1] -= particle.mass * particle.velocity[1];
    };
    count(left, at.walls[left]);
    count(right, at.walls[right]);
    count(middle, at.middle);
  }



  void
  FlowProfile::end_pass(const MPI_Comm communicator)
  {
    if (bands.empty())
      return;
    Sums of_all(sums.size());
    Utilities::MPI::sum(of_rank, communicator, of_all);
    of_rank.assign(of_rank.size(), 0.);
    for (std::size_t i = 0; i < sums.size(); ++i)
      sums[i] += of_all[i];
  }



  void
  FlowProfile::end_interval(const double discharged_mass)
  {
    if (bands.empty())
      return;
    intervals.push_back({discharged_mass, sums});
    sums.assign(sums.size(), 0.);
  }



  std::vector<FlowLevel>
  FlowProfile::levels() const
  {
    Sums         total(sums.size(), 0.);
    const double mass =
      intervals.empty() ? 0. : intervals.back().discharged_mass;
    for (const Interval &interval : intervals)
      if (interval.discharged_mass > 0.25 * mass &&
          interval.discharged_mass <= 0.75 * mass)
        for (std::size_t i = 0; i < total.size(); ++i)
          total[i] += interval.sums[i];

    std::vector<FlowLevel> result;
    for (const unsigned int side : {left, right})
      for (std::size_t band = 0; band < bands.size(); ++band)
        {
          if (std::isnan(bands[band].walls[side]))
            continue;
          const auto speed = [&](const unsigned int place) {
            return total[index(band, place) + 1] / total[index(band, place)];
          };
          result.push_back({(bands[band].lower + bands[band].upper) / 2.,
                            bands[band].upper,
                            side == left ? "left" : "right",
                            speed(side),
                            speed(middle)});
        }
    return result;
  }
} // namespace Sandglass
