#ifndef sandglass_material_circular_cone_h
#define sandglass_material_circular_cone_h

#include <sandglass/continuum/symmetric_components.h>
#include <sandglass/material/material_constants.h>

#include <cmath>

namespace Sandglass
{
  /// A limit of q in Pa as a quotient, so that who divides by q divides once.
  template <typename Number>
  struct DeviatorLimit
  {
    Number numerator;   ///< in Pa
    Number denominator; ///< at least 1/2

    Number
    value() const
    {
      return numerator / denominator;
    }
  };

  /// q = slope * p + strength: a cone whose sections of constant pressure are
  /// circles (Drucker and Prager).
  struct CircularCone
  {
    double slope    = 0.;
    double strength = 0.; ///< without pressure, in Pa

    /**
     * Of the cone that shares an angle with Mohr and Coulomb's pyramid.
     *
     * @param angle  whose angle it is.
     * @param sine   of the angle of internal friction phi.
     * @return slope / sin(phi), and strength / (c cos(phi)) for a cohesion c.
     */
    static double
    slope_per_sine(const YieldCone angle, const double sine)
    {
      if (angle == YieldCone::plane_strain)
        return std::sqrt(3.);
      if (angle == YieldCone::compression)
        return 6. / (3. - sine);
      return 18. / (9. - sine * sine); // the paper's, Section 2.2
    }

    CircularCone() = default;

    /// @param strength  in Pa.
    CircularCone(const double slope, const double strength)
      : slope(slope)
      , strength(strength)
    {}

    /**
     * @param angle           see slope_per_sine().
     * @param friction_angle  phi in rad.
     * @param cohesion        c in Pa.
     */
    CircularCone(const YieldCone angle,
                 const double    friction_angle,
                 const double    cohesion)
    {
      const double sine   = std::sin(friction_angle);
      const double factor = slope_per_sine(angle, sine);
      slope               = factor * sine;
      strength            = factor * cohesion * std::cos(friction_angle);
    }

    /// Largest q at a pressure in Pa.
    template <int n, typename Number>
    DeviatorLimit<Number>
    largest_deviator(const Number &pressure,
                     const Eigen::Matrix<Number, n, 1> & /*deviator*/,
                     const Number & /*squared_von_mises_stress*/) const
    {
      return {Number(slope) * pressure + Number(strength), Number(1.)};
    }

    /// Derivative of largest_deviator() with respect to the stress.
    template <int n>
    SymmetricComponents<n>
    gradient(const double /*pressure*/,
             const Eigen::Matrix<double, n, 1> & /*deviator*/) const
    {
      return isotropic<n>(-slope / 3.);
    }

    /// Slope of q over p where the material is compressed along one axis.
    double
    slope_in_compression() const
    {
      return slope;
    }
  };
} // namespace Sandglass

#endif
