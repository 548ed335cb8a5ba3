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

    /// Which case a trial stress belongs to.
    Case
    classify(const SymmetricTensor4 &trial_stress) const
    {
      const double p         = pressure(trial_stress);
      const double q_squared = squared_von_mises_stress(trial_stress);
      if (p > 0.)
        return q_squared <= yield_slope * p * yield_slope * p ? Case::elastic :
                                                                Case::yielding;
      return p == 0. && q_squared == 0. ? Case::elastic : Case::separated;
    }

    /**
     * Project an elastic trial stress onto the admissible stresses (three-case
     * formula of Section 4.1).
     *
     * @param[in,out] stress  trial stress in, admissible stress out.
     * @return the plastic work per volume in J/m^3, stress : plastic strain
     *         increment.
     */
    template <typename Number>
    Number
    project(SymmetricTensorOf<Number> &stress) const
    {
      using std::sqrt;
      const Number                    p = pressure(stress);
      const SymmetricTensorOf<Number> s = stress + isotropic(p);
      const Number q_squared = Number(1.5) * double_contraction(s, s);
      const Number q_yield   = Number(yield_slope) * p;

      // Asked so that what is not a number yields, and spreads to all
      // components: else one that no force feels would stay unseen.
      const auto   is_separated = p <= Number(0.);
      const auto   is_elastic   = q_squared <= q_yield * q_yield;
      const Number ratio =
        select(is_elastic, Number(1.), q_yield / sqrt(q_squared));
      for (unsigned int c = 0; c < 4; ++c)
        {
          const Number normal = c == Component::xy ? Number(0.) : p;
          stress[c] =
            select(is_separated,
                   Number(0.),
                   select(is_elastic, stress[c], ratio * s[c] - normal));
        }
      // The plastic strain increment is (1 - ratio) s / (2 G).
      return select(is_separated,
                    Number(0.),
                    ratio * (Number(1.) - ratio) * q_squared *
                      Number(1. / (3. * elasticity.shear_modulus)));
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
