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

  /**
   * The same for an outlet of any shape, in kg/s: 4/pi 35/60 sqrt(g D*) rho A*
   * with the hydraulic diameter D* = 4 A* / P* of what is left of the outlet
   * when a strip of 0.7 d along its lips is taken away. Exact for circles; for
   * slots 0.99 of the plane formula, for squares 1.27 of the circle's rate
   * with the same width, which is the ratio of their areas.
   *
   * @param area        of the outlet, in m^2
   * @param lip_length  of its edges other than where it ends at a wall, in m
   * @param is_closed   whether these go all round
   * @param grain_size  d, in m
   */
  double
  beverloo_flow_rate(const double density,
                     const double gravity,
                     const double area,
                     const double lip_length,
                     const bool   is_closed,
                     const double grain_size);
} // namespace Sandglass

#endif
