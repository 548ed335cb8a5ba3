#ifndef sandglass_observers_flow_rate_h
#define sandglass_observers_flow_rate_h

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

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &samples;
    }

  private:
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

    /// When the mass had been discharged, in s, between samples linearly.
    double
    time_of(const double mass) const;

    const double        window;
    std::vector<Sample> samples;
  };
} // namespace Sandglass

#endif
