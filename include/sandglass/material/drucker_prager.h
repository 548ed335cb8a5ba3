#ifndef sandglass_material_drucker_prager_h
#define sandglass_material_drucker_prager_h

#include <sandglass/material/elasticity.h>

#include <Eigen/Core>

#include <cmath>

namespace Sandglass
{
  /**
   * Cohesionless Drucker-Prager plasticity, f = q - m p, with the plastic
   * potential g = q, so that plastic flow keeps the volume (paper, Sections 2.2
   * and 4.1).
   */
  class DruckerPrager
  {
  public:
    /// Where the elastic trial stress lay, in the order of Section 4.1.
    enum class Case
    {
      elastic,  ///< within the yield surface: kept
      yielding, ///< outside, compressed: deviator scaled back at constant p
      separated ///< outside, not compressed: stress vanishes
    };

    /**
     * m = 18 sin(phi) / (9 - sin^2(phi)).
     *
     * @param friction_angle  internal friction angle phi in rad.
     */
    static double
    slope(const double friction_angle)
    {
      const double sine = std::sin(friction_angle);
      return 18. * sine / (9. - sine * sine);
    }

    DruckerPrager(const Elasticity &elasticity, const double friction_angle)
      : elasticity(elasticity)
      , yield_slope(slope(friction_angle))
    {}

    /// f = q - m p in Pa; positive outside the yield surface.
    double
    yield_function(const SymmetricTensor4 &stress) const
    {
      return von_mises_stress(stress) - yield_slope * pressure(stress);
    }

    /**
     * Project an elastic trial stress onto the admissible stresses (three-case
     * formula of Section 4.1).
     *
     * @param[in,out] stress  trial stress in, admissible stress out.
     * @param[in,out] dissipation  raised by the plastic work per volume in
     *                             J/m^3, stress : plastic strain increment.
     */
    Case
    project(SymmetricTensor4 &stress, double &dissipation) const
    {
      const double           p         = pressure(stress);
      const SymmetricTensor4 s         = deviator(stress);
      const double           q_squared = 1.5 * double_contraction(s, s);
      const double           q_yield   = yield_slope * p;

      if (p > 0.)
        {
          if (q_squared <= q_yield * q_yield)
            return Case::elastic;
          const double ratio = q_yield / std::sqrt(q_squared);
          stress             = ratio * s - SymmetricTensor4(p, p, p, 0.);
          // The plastic strain increment is (1 - ratio) s / (2 G).
          dissipation +=
            ratio * (1. - ratio) * q_squared / (3. * elasticity.shear_modulus);
          return Case::yielding;
        }

      if (p == 0. && q_squared == 0.)
        return Case::elastic;
      // What is not a number stays so, or the run would go on with it unseen.
      stress.setConstant(p <= 0. ? 0. : p);
      return Case::separated;
    }

    /**
     * Derivative of project() with respect to the trial stress: a 4 x 4 matrix
     * that maps increments of (xx, yy, zz, xy) to such increments.
     */
    Eigen::Matrix4d
    projection_derivative(const SymmetricTensor4 &trial_stress) const;

    const Elasticity elasticity;
    const double     yield_slope;
  };
} // namespace Sandglass

#endif
