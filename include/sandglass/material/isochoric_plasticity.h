#ifndef sandglass_material_isochoric_plasticity_h
#define sandglass_material_isochoric_plasticity_h

#include <sandglass/continuum/material_tangent.h>
#include <sandglass/material/elasticity.h>
#include <sandglass/material/law_defaults.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  /**
   * Linear elasticity within a cone, and plastic flow that keeps the volume:
   * the potential is g = q, so the return to the cone shrinks the deviator
   * (paper, Sections 2.2 and 4.1). What laws of different cones share.
   *
   * Tension beyond the cut-off separates the material: no stress is left until
   * it is as dense as without stress again.
   *
   * @tparam Cone  has largest_deviator(), a DeviatorLimit, gradient() and
   * slope_in_compression(); see CircularCone.
   */
  template <typename Cone>
  class IsochoricPlasticity : public LawDefaults
  {
  public:
    static constexpr bool has_cohesion = true;

    /// @param largest_tension  the cut-off of -p, in Pa, at least 0.
    IsochoricPlasticity(const Elasticity &elasticity,
                        const Cone       &cone,
                        const double      largest_tension)
      : elasticity(elasticity)
      , cone(cone)
      , smallest_pressure(-largest_tension)
    {}

    /// The density, as a share of that of unstressed material, below which
    /// there is no stress: where elastic expansion reaches the cut-off.
    double
    loosest_density_share() const
    {
      return std::exp(smallest_pressure / elasticity.bulk_modulus());
    }

    /// State variables of unstressed material: none.
    std::array<double, 0>
    initial_state() const
    {
      return {};
    }

    /// The elastic change of stress in Pa.
    template <typename Increment>
    auto
    predict(const Increment &increment, const double /*time_step*/) const
    {
      return elasticity.stress(increment.strain);
    }

    /**
     * Add the prediction to a stress, and project the result onto the
     * admissible stresses.
     *
     * @param[in,out] stress  at the start of the step, turned, in Pa; at its
     * end.
     * @return the plastic work per volume in J/m^3, stress : plastic strain
     *         increment.
     */
    template <int n, typename Number, typename State, typename Prediction>
    Number
    correct(Eigen::Matrix<Number, n, 1> &stress,
            State &,
            const Prediction &prediction) const
    {
      for (int c = 0; c < n; ++c)
        stress[c] += prediction[c];
      return project(stress);
    }

    /**
     * Project a trial stress onto the admissible stresses (three-case formula
     * of Section 4.1).
     *
     * @return as correct().
     */
    template <int n, typename Number>
    Number
    project(Eigen::Matrix<Number, n, 1> &stress) const
    {
      using std::sqrt;
      const Number                         p = pressure(stress);
      const SymmetricComponents<n, Number> s = stress + isotropic<n>(p);
      const Number q_squared = Number(1.5) * double_contraction(s, s);
      const auto   limit     = cone.largest_deviator(p, s, q_squared);

      const auto is_elastic =
        q_squared * limit.denominator * limit.denominator <=
        limit.numerator * limit.numerator;
      const Number ratio =
        select(is_elastic,
               Number(1.),
               limit.numerator / (limit.denominator * sqrt(q_squared)));
      return shrink(stress, p, s, q_squared, is_elastic, ratio);
    }

    /**
     * Shrink the deviator of a trial stress, or take all stress away where
     * tension is beyond the cut-off.
     *
     * @param[in,out] stress  the trial stress; p, s and q_squared are its own.
     * @param is_elastic  where it stays as it is. A comparison that holds for
     * no stress that is not a number makes this one yield, and spread to all
     * components. Otherwise it would stay unseen in a component that no force
     * feels.
     * @param ratio  of the deviators; 1 where is_elastic.
     * @return as correct().
     */
    template <int n, typename Number, typename Mask>
    Number
    shrink(Eigen::Matrix<Number, n, 1>          &stress,
           const Number                         &p,
           const SymmetricComponents<n, Number> &s,
           const Number                         &q_squared,
           const Mask                           &is_elastic,
           const Number                         &ratio) const
    {
      const auto is_separated = p <= Number(smallest_pressure);
      for (int c = 0; c < n; ++c)
        {
          const Number normal = c < Component::first_shear ? p : Number(0.);
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
     * Tangent of correct() as Newton's method uses it, also where the
     * projection's derivative is zero or doesn't exist.
     *
     * @param stress  at the increment's start, turned, in Pa.
     * @param elastic_share  from 0, the derivative, to 1, the elastic
     * stiffness.
     */
    template <int n, typename State, typename Increment>
    MaterialTangent<n>
    tangent(const Eigen::Matrix<double, n, 1> &stress,
            const State &,
            const Increment &increment,
            const double     elastic_share) const
    {
      const SymmetricComponents<n> trial_stress =
        stress + predict(increment, 0.);
      const ComponentMatrix<n> projection =
        stabilized_projection_derivative(trial_stress, elastic_share);
      return {projection, projection * elasticity.template stiffness<n>()};
    }

    /// An isotropic elasticity that is nowhere softer than the law.
    Elasticity
    stiffness_bound() const
    {
      return elasticity;
    }

    /// Elastic energy per volume in J/m^3.
    template <int n, typename Number, typename State>
    Number
    energy_density(const Eigen::Matrix<Number, n, 1> &stress,
                   const State &) const
    {
      return elasticity.energy_density(stress);
    }

    /// q less the cone's, in Pa; positive outside the yield surface.
    template <int n>
    double
    yield_function(const Eigen::Matrix<double, n, 1> &stress) const
    {
      return von_mises_stress(stress) -
             cone
               .largest_deviator(pressure(stress),
                                 deviator(stress),
                                 squared_von_mises_stress(stress))
               .value();
    }

    /// Derivative of project() with respect to the trial stress.
    template <int n>
    ComponentMatrix<n>
    projection_derivative(const Eigen::Matrix<double, n, 1> &trial_stress) const
    {
      const double p = pressure(trial_stress);
      const double q = von_mises_stress(trial_stress);
      if (p <= smallest_pressure && q > 0.)
        return ComponentMatrix<n>::Zero();
      const SymmetricComponents<n> s = deviator(trial_stress);
      const double q_yield = cone.largest_deviator(p, s, q * q).value();
      if (q <= q_yield || q == 0.)
        return ComponentMatrix<n>::Identity();

      // stress = (q_yield / q) s - p 1, differentiated with
      // dp = -1/3 1 : d(trial), dq = 3 / (2 q) s : d(trial)
      const SymmetricComponents<n> identity   = isotropic<n>(1.);
      const SymmetricComponents<n> p_gradient = -identity / 3.;
      SymmetricComponents<n>       q_gradient = 1.5 / q * s;
      for (int c = Component::first_shear; c < n; ++c)
        q_gradient[c] *= 2.;

      const double             ratio = q_yield / q;
      const ComponentMatrix<n> deviatoric =
        ComponentMatrix<n>::Identity() + identity * p_gradient.transpose();
      return ratio * deviatoric +
             s *
               (cone.gradient(p, s) / q - ratio / q * q_gradient).transpose() -
             identity * p_gradient.transpose();
    }

    /// As tangent() takes it, see there.
    template <int n>
    ComponentMatrix<n>
    stabilized_projection_derivative(
      const Eigen::Matrix<double, n, 1> &trial_stress,
      const double                       elastic_share) const
    {
      // Share of the elastic stiffness that separated points keep in the
      // tangent (not in the forces). Without it, a node all of whose cells are
      // separated would have an equation of zeros.
      constexpr double separated_stiffness = 1e-3;

      const ComponentMatrix<n> identity = ComponentMatrix<n>::Identity();
      if (smallest_pressure == 0. && trial_stress.isZero(0.))
        {
          // The apex of the cone. Laterally confined compression, elastic with
          // q / p = 2 G / K, leaves it along the yield surface if that is
          // steeper: take its secant, which scales the deviator.
          const double ratio =
            std::min(1.,
                     cone.slope_in_compression() * elasticity.bulk_modulus() /
                       (2. * elasticity.shear_modulus));
          const SymmetricComponents<n> one = isotropic<n>(1.);
          return ratio * identity + (1. - ratio) / 3. * one * one.transpose();
        }
      if (pressure(trial_stress) <= smallest_pressure)
        return std::max(separated_stiffness, elastic_share) * identity;
      return (1. - elastic_share) * projection_derivative(trial_stress) +
             elastic_share * identity;
    }

    const Elasticity elasticity;
    const Cone       cone;
    const double     smallest_pressure; ///< in Pa, at most 0
  };
} // namespace Sandglass

#endif
