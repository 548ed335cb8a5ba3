#include <sandglass/study/free_rate.h>

#include <cmath>

namespace Sandglass
{
  bool
  has_slot(const SceneParameters &scene)
  {
    return scene.formulation == Formulation::plane_strain ||
           (scene.formulation == Formulation::three_dimensions &&
            scene.outlet_shape == SceneParameters::OutletShape::slot);
  }



  double
  free_rate(const SceneParameters &scene,
            const double           density,
            const double           width)
  {
    const bool   is_body = scene.formulation == Formulation::three_dimensions;
    const double root    = std::sqrt(scene.gravity_vector<3>().norm());
    if (!has_slot(scene))
      return density * root * std::pow(width, 2.5);
    const double length = is_body ? 2. * scene.whole_half_depth() : 1.;
    return density * root * std::pow(width, 1.5) * length;
  }
} // namespace Sandglass
