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
  class MuI
  {
  public:
    static constexpr char name[] = "mu(I)";
    static constexpr char description[] =
      "friction that grows with the rate of shear, incompressible plastic flow "
      "(mu(I))";

    static constexpr std::array<StateVariable, 0> state_variables = {};

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

    static constexpr bool has_cohesion             = true;
    static constexpr bool dissipation_can_fall     = false;
    static constexpr bool can_fail                 = false;
    static constexpr bool pressure_follows_density = true;
    static constexpr bool takes_averaged_strain    = true;
    static constexpr bool has_constant_stiffness   = true;

    static bool
    is_meant(const MaterialConstants &constants)
    {
      return constants.model == name;
    }

    explicit MuI(const MaterialConstants &constants)
      : elasticity(constants.young_modulus, constants.poisson_ratio)
      , slow(std::tan(friction_angle(constants)))
      , fast(std::tan(law_constant<MuI>(constants, "phi_2") * pi / 180.))
      , cohesion(constants.cohesion)
      , smallest_pressure(
          -largest_tension(friction_angle(constants), constants.cohesion))
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

    std::array<double, 0>
    initial_state() const
    {
      return {};
    }

    double
    loosest_density_share() const
    {
      return std::exp(smallest_pressure / elasticity.bulk_modulus());
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

    /// See IsochoricPlasticity::tangent(); material at rest shears infinitely
    /// slowly.
    template <int n, typename State, typename Increment>
    MaterialTangent<n>
    tangent(const Eigen::Matrix<double, n, 1> &stress,
            const State                       &state,
            const Increment                   &increment,
            const double                       elastic_share) const
    {
      CircularCone cone;
      cone.slope    = std::sqrt(3.) * slow;
      cone.strength = std::sqrt(3.) * cohesion;
      return IsochoricPlasticity<CircularCone>(elasticity,
                                               cone,
                                               -smallest_pressure)
        .tangent(stress, state, increment, elastic_share);
    }

    Elasticity
    stiffness_bound() const
    {
      return elasticity;
    }

    template <int n, typename Number, typename State>
    Number
    energy_density(const Eigen::Matrix<Number, n, 1> &stress,
                   const State &) const
    {
      return elasticity.energy_density(stress);
    }

  private:
    static constexpr double pi = 3.14159265358979323846;

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
      const Number tau          = sqrt(Number(0.5) * double_contraction(s, s));
      const Number over         = tau - Number(cohesion);
      const Number p_in_contact = select(p > Number(0.), p, Number(0.));
      const Number at_rest      = Number(slow) * p_in_contact;
      const Number at_most      = Number(fast) * p_in_contact;
      const Number viscous      = shear * sqrt(p_in_contact);

      const Number b     = at_most + over + viscous;
      const Number h     = at_most * over + at_rest * viscous;
      const Number twice = b + sqrt(b * b - Number(4.) * h);

      // In this order, a stress that is not a number spreads; see
      // IsochoricPlasticity.
      const auto   is_separated = p <= Number(smallest_pressure);
      const auto   is_elastic   = over <= at_rest;
      const Number ratio =
        select(is_elastic,
               Number(1.),
               (Number(cohesion) * twice + Number(2.) * h) / (twice * tau));
      for (int c = 0; c < n; ++c)
        {
          const Number normal = c < Component::first_shear ? p : Number(0.);
          stress[c] =
            select(is_separated,
                   Number(0.),
                   select(is_elastic, stress[c], ratio * s[c] - normal));
        }
      return select(is_separated,
                    Number(0.),
                    ratio * (Number(1.) - ratio) * tau * tau *
                      Number(1. / elasticity.shear_modulus));
    }

    const Elasticity elasticity;
    const double     slow;     ///< mu_s
    const double     fast;     ///< mu_2
    const double     cohesion; ///< in Pa
    const double     smallest_pressure;
    /// G I_0 / (d sqrt(rho_s)), in Pa^(1/2) / s
    const double shear_per_step;
  };
} // namespace Sandglass

#endif
