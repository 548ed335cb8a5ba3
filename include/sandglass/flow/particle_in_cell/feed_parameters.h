#ifndef sandglass_flow_particle_in_cell_feed_parameters_h
#define sandglass_flow_particle_in_cell_feed_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <optional>
#include <utility>
#include <vector>

namespace Sandglass
{
  /// What enters the silo while material flows.
  enum class FeedKind
  {
    none,
    level, ///< as much as keeps the surface where it is at the start
    rain   ///< a stream through the top
  };

  /// Pairs of an initial particle's id and how many have been fed at its place.
  using FedNumbers = std::vector<std::pair<unsigned int, unsigned int>>;

  /// Section `Feed`: how material enters while other material flows.
  class FeedParameters : public dealii::ParameterAcceptor
  {
  public:
    FeedParameters();

    FeedKind              kind = FeedKind::none;
    std::optional<double> left, right; ///< of the opening, in m
    double                rate  = 0.;  ///< of the rain, in kg/s, whole silo
    double                speed = 1.;  ///< downwards, in m/s
    double                start = 0.;  ///< in s
    std::optional<double> end;         ///< in s

    /// Whether an x, in m, is within the opening.
    bool
    is_in_opening(const double x) const
    {
      return (!left || x >= *left) && (!right || x <= *right);
    }

    /// Whether there is something to feed at this time, in s.
    bool
    is_on_at(const double time) const
    {
      return time >= start && (!end || time < *end);
    }

    /// Throws InputError where values contradict each other.
    void
    check() const;
  };
} // namespace Sandglass

#endif
