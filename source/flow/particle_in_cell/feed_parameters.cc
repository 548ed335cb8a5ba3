#include <sandglass/base/exceptions.h>
#include <sandglass/base/number_text.h>
#include <sandglass/base/parameter_entries.h>
#include <sandglass/flow/particle_in_cell/feed_parameters.h>


namespace Sandglass
{
  FeedParameters::FeedParameters()
    : ParameterAcceptor("Feed")
  {
    using Bounds = BoundedNumber;

    add_selection<FeedKind>(
      *this,
      "Kind",
      kind,
      {{"none", FeedKind::none},
       {"level", FeedKind::level},
       {"rain", FeedKind::rain}},
      "What enters while material flows (Flow/Method = particle-in-cell only): "
      "nothing; as much as has passed the outlets, where the material's "
      "surface has sunk most since the start, moving as the material does "
      "there; or a stream that falls through the top.");
    add_optional_number(*this,
                        "Opening left",
                        left,
                        Bounds::any(),
                        "m",
                        "Left end (x) of the opening through which material "
                        "enters; empty: that of the silo.");
    add_optional_number(*this,
                        "Opening right",
                        right,
                        Bounds::any(),
                        "m",
                        "Right end of the opening; empty: that of the silo.");
    add_number(*this,
               "Rate",
               rate,
               Bounds::at_least(0.),
               "kg/s",
               "Mass of rain per time, of the whole silo (plane strain: per "
               "metre of depth).");
    add_number(*this,
               "Speed",
               speed,
               Bounds::greater_than(0.),
               "m/s",
               "Speed with which rain enters, downwards.");
    add_number(*this,
               "Start time",
               start,
               Bounds::at_least(0.),
               "s",
               "When feeding begins.");
    add_optional_number(*this,
                        "End time",
                        end,
                        Bounds::at_least(0.),
                        "s",
                        "When feeding ends; empty: never.");
  }



  void
  FeedParameters::check() const
  {
    if (kind == FeedKind::none)
      return;
    if (kind == FeedKind::rain && rate == 0.)
      throw InputError("Feed",
                       "Rate",
                       "0",
                       "allowed is a rate greater than 0 with Kind = rain");
    if (left && right && *left >= *right)
      throw InputError("Feed",
                       "Opening right",
                       number_text(*right),
                       "allowed is more than the Opening left of " +
                         number_text(*left) + " m");
    if (end && *end <= start)
      throw InputError("Feed",
                       "End time",
                       number_text(*end),
                       "allowed is more than the Start time of " +
                         number_text(start) + " s");
  }
} // namespace Sandglass
