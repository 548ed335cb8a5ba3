#include <sandglass/output/beverloo.h>

#include <cmath>

namespace Sandglass
{
  double
  beverloo_flow_rate(const Formulation formulation,
                     const double      density,
                     const double      gravity,
                     const double      outlet_width,
                     const double      grain_size)
  {
    if (formulation == Formulation::plane_strain)
      return 45. / 60. * std::sqrt(2. * gravity) * density *
             std::pow(outlet_width * (1. - 0.7 * grain_size), 1.5);
    return 35. / 60. * std::sqrt(gravity) * density *
           std::pow(outlet_width * (1. - 1.4 * grain_size), 2.5);
  }
} // namespace Sandglass
