#ifndef sandglass_output_eurocode_pressures_h
#define sandglass_output_eurocode_pressures_h

#include <sandglass/continuum/formulation.h>
#include <sandglass/output/janssen.h>

#include <limits>
#include <optional>

namespace Sandglass
{
  /// Pressure and friction on a wall, in Pa; NaN where a formula says nothing.
  struct WallPressure
  {
    double normal     = std::numeric_limits<double>::quiet_NaN();
    double tangential = std::numeric_limits<double>::quiet_NaN();
  };

  /**
   * The symmetrical filling and discharge pressures and the patch loads of EN
   * 1991-4:2006 on vertical walls (Sections 5.2 and 5.3) of slender (h_c / d_c
   * >= 2), intermediately slender (1 < h_c / d_c < 2) and squat (0.4 < h_c /
   * d_c <= 1) silos, and the pressures on their steep and shallow hoppers
   * (Sections 6.3 and 6.4). Retaining silos, flat bottoms and the flow channels
   * of large outlet eccentricities (Section 5.2.4) are left out.
   *
   * The factors are those of action assessment classes 2 and 3; K, mu and phi
   * are what the caller gives, not upper or lower characteristic values. The
   * surface is level: the pile's height h_o and slope phi_r in Section 5.3 are
   * zero, and so is the filling's eccentricity e_f.
   */
  class EurocodePressures
  {
  public:
    struct Silo
    {
      Formulation formulation;
      double      width;       ///< d_c between the vertical walls, in m
      double      wall_height; ///< h_c from their foot to the surface, in m
      /// Distance between the middles of outlet and silo, in m.
      double outlet_eccentricity;
      /// tan(beta) between hopper and vertical; NaN without a hopper, or with
      /// one that is not the same on both sides.
      double hopper_slope;
      double internal_friction_angle; ///< phi, in degrees
      /// mu_h; none: that of the vertical wall.
      std::optional<double> hopper_friction_coefficient = {};
      /// C_op, the solid's reference factor for patch loads (Table E.1).
      double patch_load_factor = 1.;
    };

    EurocodePressures(const Silo &silo, const Janssen &janssen);

    enum class Load
    {
      filling,
      discharge
    };

    /**
     * Pressure and friction on the vertical wall: Janssen's p_h (Section
     * 5.2.1.1) or p_ho Y_R (Section 5.3.1.1) on filling; times C_h and C_w
     * (Sections 5.2.2.1 and 5.3.2.1) on discharge, if the outlet is no farther
     * from the middle than 0.25 d_c.
     *
     * @param depth  below the surface, in m.
     */
    WallPressure
    on_wall(const Load load, const double depth) const;

    /**
     * The pressure in Pa that a patch load adds to that on the vertical wall at
     * a depth: C_pf p_hf (eqs. 5.8 to 5.11) on filling, C_pe p_he (eqs. 5.27 to
     * 5.30) on discharge, with the outlet's eccentricity. In plane strain it is
     * the band of silos that are not round, 0.36 times as much (eqs. 5.17 and
     * 5.37). NaN where on_wall() is.
     *
     * @param depth  below the surface, in m.
     */
    double
    patch(const Load load, const double depth) const;

    /**
     * Pressure and friction on the hopper: full wall friction on steep ones
     * (Sections 6.1.2, 6.3.2 and 6.3.3), mu_heff = (1 - K) / (2 tan(beta)) on
     * shallow ones (Section 6.4), whose pressures on discharge are those on
     * filling. The bottom load magnifier is C_b = 1.
     *
     * @param depth  below the surface, in m.
     */
    WallPressure
    on_hopper(const Load load, const double depth) const;

  private:
    bool
    is_slender() const;
    bool
    is_intermediate() const;
    /// Whether it is slender, intermediate or squat.
    bool
    is_silo() const;
    bool
    has_steep_hopper() const;

    /// mu_h, or mu_heff where the hopper is shallow.
    double
    hopper_friction() const;

    /// C_pf or C_pe.
    double
    patch_factor(const Load load) const;

    /// z / z_o, the depth over Janssen's characteristic depth.
    double
    relative_depth(const double depth) const;

    /// Whether the outlet is near enough to the middle for Section 5.3.2.
    bool
    has_central_outlet() const;

    /// Mean vertical pressure p_vf in the vertical section, in Pa.
    double
    vertical_pressure(const double depth) const;

    /// Ratio F of the pressures across and along the hopper's axis.
    double
    hopper_ratio(const Load load) const;

    const Silo    silo;
    const Janssen janssen;
  };
} // namespace Sandglass

#endif
