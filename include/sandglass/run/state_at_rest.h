#ifndef sandglass_run_state_at_rest_h
#define sandglass_run_state_at_rest_h

#include <sandglass/run/part.h>

#include <optional>

namespace Sandglass
{
  /**
   * The state at rest, by the static stage, carried to the flow's particles;
   * where nothing can leave they settle then at their own rest. Writes
   * static.vtu. Collective. Throws RunError, with doubts about the material's
   * stiffness where there is no state at rest or where it settles too much.
   *
   * @return  what output shows of it; nothing where the parameters leave the
   *          static stage out, and the flow is as it was.
   */
  template <int dim>
  std::optional<AtRest>
  find_state_at_rest(const Parameters &parameters,
                     Part<dim>        &part,
                     Log              &log,
                     TimerOutput      &timings);
} // namespace Sandglass

#endif
