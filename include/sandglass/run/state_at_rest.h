#ifndef sandglass_run_state_at_rest_h
#define sandglass_run_state_at_rest_h

#include <sandglass/run/part.h>

#include <functional>
#include <optional>

namespace Sandglass
{
  /**
   * The state at rest, by the static stage, carried to the flow's particles;
   * where nothing can leave they settle then at their own rest. Writes
   * static.vtu. Collective. Throws RunError, with doubts about the material's
   * stiffness where there is no state at rest or where it settles too much.
   *
   * @param after_load_step  is called after each.
   * @return  what output shows of it; nothing where the parameters leave the
   *          static stage out, and the flow is as it was.
   */
  template <int dim>
  std::optional<AtRest>
  find_state_at_rest(const Parameters            &parameters,
                     Part<dim>                   &part,
                     Log                         &log,
                     TimerOutput                 &timings,
                     const std::function<void()> &after_load_step);
} // namespace Sandglass

#endif
