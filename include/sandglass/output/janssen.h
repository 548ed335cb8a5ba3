#ifndef sandglass_output_janssen_h
#define sandglass_output_janssen_h

namespace Sandglass
{
  /**
   * Janssen's pressures at rest in a silo with vertical walls (EN 1991-4,
   * Section 5.2.1, filling): p_h = gamma K z0 (1 - exp(-z / z0)) with
   * z0 = A / (U K mu). Without wall friction, p_h = gamma K z.
   */
  struct Janssen
  {
    double weight_density;         ///< gamma = rho g, in N/m^3
    double hydraulic_radius;       ///< area A over perimeter U, in m
    double lateral_pressure_ratio; ///< K
    double friction_coefficient;   ///< mu of the wall

    /// EN 1991-4, eq. 4.7: K = 1.1 (1 - sin(phi)), phi in degrees.
    static double
    standard_lateral_pressure_ratio(const double internal_friction_angle);

    /**
     * p_h on the wall, in Pa.
     *
     * @param depth  z below the free surface, in m.
     */
    double
    horizontal_pressure(const double depth) const;

    /// p_v = p_h / K on the bottom, in Pa.
    double
    vertical_pressure(const double depth) const
    {
      return horizontal_pressure(depth) / lateral_pressure_ratio;
    }
  };
} // namespace Sandglass

#endif
