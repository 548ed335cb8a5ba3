#ifndef sandglass_scene_body_plan_steps_h
#define sandglass_scene_body_plan_steps_h

#include <vector>

namespace Sandglass
{
  /// How many cells of about a size lie along a length, both in m; at least
  /// one.
  unsigned int
  n_cells_along(const double length, const double size);

  /// Shares of a length, from 0 to 1, that cut it into n equal steps.
  std::vector<double>
  equal_steps(const unsigned int n);

  /// Likewise into steps of which the first is as long as `first`, each longer
  /// by a fifth of the distance, at most `last` (m).
  std::vector<double>
  graded_steps(const double length, const double first, const double last);
} // namespace Sandglass

#endif
