#ifndef sandglass_output_jenike_h
#define sandglass_output_jenike_h

#include <sandglass/continuum/formulation.h>

namespace Sandglass
{
  /// Jenike's design of hoppers (jenike1964): what is needed to make a cohesive
  /// material flow. Angles in rad.
  struct Jenike
  {
    Formulation formulation = Formulation::plane_strain;
    /// Effective angle of internal friction delta; of a linear yield locus that
    /// is phi itself.
    double friction_angle      = 0.;
    double wall_friction_angle = 0.;
    /// Between the hopper's wall and the vertical; 0 for a flat bottom.
    double hopper_angle = 0.;

    /// Stresses at the wall over gamma r, with the distance r from the apex and
    /// the weight density gamma.
    struct RadialStress
    {
      double mean;   ///< of the largest and the smallest principal stress
      double normal; ///< on the wall
    };

    /// The radial stress field of slow mass flow; not a number where there is
    /// none.
    RadialStress
    radial_stress() const;

    /**
     * Flow factor ff: the stress that consolidates the material in the hopper
     * over that which an arch has to carry.
     *
     * @return not a number where radial_stress() is none.
     */
    double
    flow_factor() const;

    /**
     * The largest angle of a cone's wall from the vertical with which all
     * material moves.
     */
    double
    mass_flow_limit() const;

    /// Width of the outlet in m below which an arch stands.
    /// @param strength  unconfined, in Pa; weight density in N/m^3.
    double
    arching_width(const double strength, const double weight_density) const;

    /// Diameter in m of a round outlet below which a pipe stands in a flat
    /// bottom.
    double
    rathole_diameter(const double strength, const double weight_density) const;

  private:
    /// H of Jenike: an arch's span over its width.
    double
    arch_factor() const;
  };
} // namespace Sandglass

#endif
