#ifndef sandglass_flow_updated_lagrangian_load_predictor_h
#define sandglass_flow_updated_lagrangian_load_predictor_h

#include <sandglass/flow/updated_lagrangian/element_grid.h>

#include <utility>

namespace Sandglass
{
  /**
   * Guesses the displacement increment of the next load step from the last two.
   * Without cohesion, displacement grows nearly in proportion to the weight,
   * and how fast it grows changes nearly linearly.
   */
  struct LoadPredictor
  {
    explicit LoadPredictor(const DisplacementVector &zero)
      : last(zero)
      , before_last(zero)
    {}

    /// @param step  share of the load that was added.
    void
    add(const double step, const DisplacementVector &increment)
    {
      std::swap(last, before_last);
      before_last_step = last_step;
      last             = increment;
      last_step        = step;
    }

    /// With ghost entries; zero as long as no step is known.
    DisplacementVector
    predict(const double step) const
    {
      DisplacementVector increment = last;
      if (before_last_step > 0.)
        {
          // between the middles of steps
          const double distance = (step + last_step) / 2.;
          const double weight =
            distance / ((last_step + before_last_step) / 2.);
          increment *= (1. + weight) * step / last_step;
          increment.add(-weight * step / before_last_step, before_last);
        }
      else if (last_step > 0.)
        increment *= step / last_step;
      increment.update_ghost_values();
      return increment;
    }

    DisplacementVector last, before_last;
    double             last_step = 0., before_last_step = 0.;
  };
} // namespace Sandglass

#endif
