#ifndef sandglass_output_flow_profile_h
#define sandglass_output_flow_profile_h

#include <sandglass/flow/flow_view.h>
#include <sandglass/output/flow_kind.h>
#include <sandglass/scene/scene.h>

#include <boost/serialization/vector.hpp>

#include <array>
#include <vector>

namespace Sandglass
{
  /// A band of heights of the silo, in which speeds beside the walls and in the
  /// middle are compared. Lengths in m.
  struct FlowBand
  {
    double lower, upper;
    double middle; ///< x of the outlet's middle
    /// x of the walls left and right of it; NaN where there is the axis.
    std::array<double, 2> walls;
    /// How far from there material is asked.
    double reach;
  };

  /// The bands of a scene from below upwards, equally high; none where nothing
  /// can leave.
  template <int dim>
  std::vector<FlowBand>
  flow_bands(const Scene<dim> &scene);

  template <>
  std::vector<FlowBand>
  flow_bands<2>(const Scene<2> &scene);

  template <>
  std::vector<FlowBand>
  flow_bands<3>(const Scene<3> &scene);

  /// How fast material sinks beside the walls and in the middle, over height
  /// and time: what tells mass flow from funnel flow.
  class FlowProfile
  {
  public:
    explicit FlowProfile(const std::vector<FlowBand> &bands);

    bool
    is_on() const
    {
      return !bands.empty();
    }

    /// Consider a particle of this rank.
    void
    add(const ParticleRecord &particle);

    /// All particles have been added. Collective.
    void
    end_pass(const MPI_Comm communicator);

    /// The passes since the last call belong to the time up to when this mass,
    /// in kg, had been discharged.
    void
    end_interval(const double discharged_mass);

    /// While the middle half of the discharged mass flowed; each side from
    /// below upwards.
    std::vector<FlowLevel>
    levels() const;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &sums &intervals;
    }

  private:
    /// Of the material somewhere in a band.
    enum Place : unsigned int
    {
      left   = 0,
      right  = 1,
      middle = 2,
      n_places
    };

    /// Mass in kg, and mass times downwards speed in kg m/s, at each place of
    /// each band.
    using Sums = std::vector<double>;

    static std::size_t
    index(const std::size_t band, const unsigned int place)
    {
      return 2 * (n_places * band + place);
    }

    struct Interval
    {
      double discharged_mass; ///< at its end, in kg
      Sums   sums;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &discharged_mass &sums;
      }
    };

    const std::vector<FlowBand> bands;
    Sums                        of_rank; ///< in this pass
    Sums                        sums;    ///< of all, since the last interval
    std::vector<Interval>       intervals;
  };
} // namespace Sandglass

#endif
