#ifndef sandglass_material_mu_i_h
#define sandglass_material_mu_i_h

#include <sandglass/base/exceptions.h>
#include <sandglass/material/drucker_prager.h>

namespace Sandglass
{
  /**
   * Friction that grows with the rate of shear: tau = c + mu(I) p with tau = q
   * / sqrt(3), mu = mu_s + (mu_2 - mu_s) / (1 + I_0 / I) and the inertial
   * number I = rate d sqrt(rho_s / p), rate that of plastic shear (jop2006).
   * mu_s = tan(phi) acts in simple shear. Linear elastic below mu_s, plastic
   * flow keeps the volume; the return to the stress at the end of a step has a
   * closed form (dunatunga2015).
   */
  class MuI : public IsochoricPlasticity<CircularCone>
  {
  public:
    static constexpr char name[] = "mu(I)";
    static constexpr char description[] =
      "friction that grows with the rate of shear, incompressible plastic flow "
      "(mu(I))";

    /// Defaults: glass beads (jop2006) of 1 mm.
    static constexpr std::array<LawConstant, 4> law_constants = {
      {{"phi_2",
        "degrees",
        32.76,
        0.,
        89.,
        "angle of friction in fast shear, not below the internal friction "
        "angle, which acts in slow shear"},
       {"I_0", "1", 0.278, 1e-6, 1e6, "inertial number of half the increase"},
       {"d", "m", 1e-3, 0., 1e3, "diameter of the grains"},
       {"rho_s", "kg/m^3", 2500., 1e-3, 1e6, "density of the grains"}}};

    static bool
    is_meant(const MaterialConstants &constants)
    {
      return constants.model == name;
    }

    explicit MuI(const MaterialConstants &constants)
      : IsochoricPlasticity(
          Elasticity(constants.young_modulus, constants.poisson_ratio),
          CircularCone(std::sqrt(3.) * std::tan(friction_angle(constants)),
                       std::sqrt(3.) * constants.cohesion),
          largest_tension(friction_angle(constants), constants.cohesion))
      , slow(std::tan(friction_angle(constants)))
      , fast(std::tan(radians(law_constant<MuI>(constants, "phi_2"))))
      , cohesion(constants.cohesion)
      , shear_per_step(elasticity.shear_modulus *
                       law_constant<MuI>(constants, "I_0") /
                       (std::max(law_constant<MuI>(constants, "d"), 1e-12) *
                        std::sqrt(law_constant<MuI>(constants, "rho_s"))))
    {
      if (fast < slow)
        throw InputError("Material",
                         "Law constants",
                         "phi_2",
                         "allowed is an angle not below the internal friction "
                         "angle");
    }

    /// The elastic change of stress in Pa, and what the root of p is multiplied
    /// with, G dt I_0 / (d sqrt(rho_s)).
    template <typename Increment>
    auto
    predict(const Increment &increment, const double time_step) const
    {
      const auto    stress = elasticity.stress(increment.strain);
      constexpr int n      = std::decay_t<decltype(stress)>::RowsAtCompileTime;
      using Number         = typename std::decay_t<decltype(stress)>::Scalar;
      Eigen::Matrix<Number, n + 1, 1> prediction;
      for (int c = 0; c < n; ++c)
        prediction[c] = stress[c];
      prediction[n] = Number(shear_in(time_step));
      return prediction;
    }

    /**
     * @param[in,out] stress  at the start of the step, turned, in Pa; at its
     * end.
     * @return the plastic work per volume in J/m^3.
     */
    template <int n, typename Number, typename State, typename Prediction>
    Number
    correct(Eigen::Matrix<Number, n, 1> &stress,
            State &,
            const Prediction &prediction) const
    {
      for (int c = 0; c < n; ++c)
        stress[c] += prediction[c];
      return project(stress, Number(prediction[n]));
    }

  private:
    /// A load step of the state at rest takes no time, but is infinitely slow.
    double
    shear_in(const double time_step) const
    {
      constexpr double infinitely_slow = 1e30;
      return time_step > 0. ? shear_per_step * time_step : infinitely_slow;
    }

    /**
     * Shrink the deviator to where the shear rate that is left over belongs to
     * mu(I): a quadratic equation for tau, of which dunatunga2015 give the root
     * without cancellation. The cohesion only shifts tau.
     */
    template <int n, typename Number>
    Number
    project(Eigen::Matrix<Number, n, 1> &stress, const Number &shear) const
    {
      using std::sqrt;
      const Number                         p = pressure(stress);
      const SymmetricComponents<n, Number> s = stress + isotropic<n>(p);
      const Number q_squared    = Number(1.5) * double_contraction(s, s);
      const Number tau          = sqrt(Number(1. / 3.) * q_squared);
      const Number over         = tau - Number(cohesion);
      const Number p_in_contact = select(p > Number(0.), p, Number(0.));
      const Number at_rest      = Number(slow) * p_in_contact;
      const Number at_most      = Number(fast) * p_in_contact;
      const Number viscous      = shear * sqrt(p_in_contact);

      const Number b     = at_most + over + viscous;
      const Number h     = at_most * over + at_rest * viscous;
      const Number twice = b + sqrt(b * b - Number(4.) * h);

      const auto   is_elastic = over <= at_rest;
      const Number ratio =
        select(is_elastic,
               Number(1.),
               (Number(cohesion) * twice + Number(2.) * h) / (twice * tau));
      return shrink(stress, p, s, q_squared, is_elastic, ratio);
    }

    const double slow;     ///< mu_s
    const double fast;     ///< mu_2
    const double cohesion; ///< in Pa
    /// G I_0 / (d sqrt(rho_s)), in Pa^(1/2) / s
    const double shear_per_step;
  };
} // namespace Sandglass

#endif
