#ifndef sandglass_study_free_rate_h
#define sandglass_study_free_rate_h

#include <sandglass/scene/scene_parameters.h>

namespace Sandglass
{
  /// Whether material flows through the outlet and arches over it as through a
  /// slot, not as through a circle; a square counts as a circle.
  bool
  has_slot(const SceneParameters &scene);

  /// rho sqrt(g) D^n, which the rate through an outlet of this width (m) is a
  /// part of; of a slot in space times its length. In kg/s, in plane strain per
  /// metre of depth.
  double
  free_rate(const SceneParameters &scene,
            const double           density,
            const double           width);
} // namespace Sandglass

#endif
