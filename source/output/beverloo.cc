#include <deal.II/base/numbers.h>

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



  double
  beverloo_flow_rate(const double density,
                     const double gravity,
                     const double area,
                     const double lip_length,
                     const bool   is_closed,
                     const double grain_size)
  {
    if (lip_length == 0.)
      return 0.;
    const double strip = 0.7 * grain_size;
    // Around circles and squares (and nearly around rectangles) the strip's
    // corners count.
    const double corners =
      is_closed ? lip_length * lip_length / (4. * area) : 0.;
    const double left = area - lip_length * strip + corners * strip * strip;
    const double lips = lip_length - 2. * corners * strip;
    return 4. / dealii::numbers::PI * 35. / 60. * density * left *
           std::sqrt(gravity * 4. * left / lips);
  }
} // namespace Sandglass
