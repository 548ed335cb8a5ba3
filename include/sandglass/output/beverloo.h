#ifndef sandglass_output_beverloo_h
#define sandglass_output_beverloo_h

#include <sandglass/continuum/formulation.h>

namespace Sandglass
{
  /**
   * The mass flow rate out of a silo by Beverloo et al. (paper, eqs 19 and 20).
   * The paper's coefficients are for g/min and cm; in SI units
   *
   *   plane:        45/60 sqrt(2 g) rho [D (1 - 0.7 d/D)]^(3/2)  in kg/(s m),
   *   axisymmetric: 35/60 sqrt(g)   rho [D (1 - 1.4 d/D)]^(5/2)  in kg/s.
   *
   * @param density        in kg/m^3
   * @param gravity        in m/s^2
   * @param outlet_width   width or diameter D of the whole outlet, in m
   * @param grain_size     diameter d of the grains over D
   */
  double
  beverloo_flow_rate(const Formulation formulation,
                     const double      density,
                     const double      gravity,
                     const double      outlet_width,
                     const double      grain_size);
} // namespace Sandglass

#endif
