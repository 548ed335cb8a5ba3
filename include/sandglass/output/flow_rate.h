#ifndef sandglass_output_flow_rate_h
#define sandglass_output_flow_rate_h

#include <sandglass/output/flow_summary.h>

#include <cstddef>
#include <vector>

namespace Sandglass
{
  /// The discharged mass over time, and mass flow rates from it.
  class FlowRate
  {
  public:
    /// @param window  time in s over which the current rate is averaged.
    explicit FlowRate(const double window);

    /// @param time  in s, later than the last one; mass in kg.
    void
    add(const double time, const double discharged_mass);

    /**
     * The mass discharged since the latest sample that is at least one window
     * old (or the first sample), over the time since; in kg/s. Zero with fewer
     * than two samples.
     */
    double
    current() const;

    /**
     * The mean rate while the middle half of all the discharged mass flowed,
     * in kg/s; NaN if none did.
     */
    double
    plateau() const;

    /// The mean rate between two times in s, in kg/s; NaN where the samples
    /// don't reach from one to the other.
    double
    mean(const double start, const double end) const;

    /// The time, in s, when a share of all the discharged mass had been
    /// discharged, interpolated linearly between samples; NaN if none was.
    double
    time_of_share(const double share) const;

    /**
     * The longest stretch of time in which no flow rate (as of current()) is
     * more than 10 % away from the middle between the largest and the smallest
     * of them, from the beginning of the first rate's window to the time of the
     * last rate. If two stretches are equally long, it is the earlier one.
     */
    SteadyFlow
    steady() const;

    /**
     * The time, in s, when 99.9 % of all the mass discharged so far had been
     * discharged; NaN while that is less than a window ago, since material
     * still flows then.
     */
    double
    discharge_time() const;

    /// All that has been discharged so far, in kg.
    double
    mass() const
    {
      return samples.empty() ? 0. : samples.back().mass;
    }

    /// How far the largest and the smallest rate since a time, in s, are from
    /// the middle between them, over it; infinite where nothing flowed or the
    /// samples don't reach back so far.
    double
    spread(const double start) const;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &samples;
    }

  private:
    /// The sample from which the rate at another one is counted.
    std::size_t
    window_start(const std::size_t sample) const;

    double
    rate(const std::size_t start, const std::size_t end) const;

    struct Sample
    {
      double time, mass;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &time &mass;
      }
    };

    /// The time, in s, when the mass had been discharged, interpolated linearly
    /// between samples.
    double
    time_of(const double mass) const;

    /// A sample's value where another one of its values, which doesn't fall,
    /// reaches `value`: linear between samples, the last one's beyond.
    double
    interpolate(const double Sample::*known,
                const double          value,
                const double Sample::*wanted) const;

    /// The discharged mass in kg at a time in s between the first and the last
    /// sample's, interpolated linearly.
    double
    mass_at(const double time) const;

    const double        window;
    std::vector<Sample> samples;
  };
} // namespace Sandglass

#endif
