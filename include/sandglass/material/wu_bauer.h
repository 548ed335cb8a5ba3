#ifndef sandglass_material_wu_bauer_h
#define sandglass_material_wu_bauer_h

#include <sandglass/material/proportional_hypoplasticity.h>

#include <cmath>

namespace Sandglass
{
  /**
   * Hypoplasticity of Wu and Bauer (1994), in the version without the void
   * ratio: with sigma* the deviator of stress and D the stretching, the rate of
   * stress is
   *
   *   C_1 tr(sigma) D + C_2 (sigma : D) / tr(sigma) sigma +
   *   (C_3 sigma^2 + C_4 sigma*^2) ||D|| / tr(sigma).
   */
  class WuBauer : public ProportionalHypoplasticity<WuBauer>
  {
  public:
    /// Value of the parameter Material/Model.
    static constexpr char name[] = "Wu-Bauer";
    /// For the documentation of that parameter.
    static constexpr char description[] =
      "hypoplasticity with four constants, stiffness in proportion to stress";

    /// By default a material with the critical friction angle 24.9 degrees and
    /// 150 times the pressure as initial Young's modulus. p_t is the weight of
    /// some 7 mm of grain: with a stiffness in proportion to stress, a tenth of
    /// it leaves Newton's method in the state at rest six times the iterations.
    static constexpr std::array<LawConstant, 5> law_constants = {
      {{"C_1", "1", -50., -1e5, 0., "factor of tr(sigma) D"},
       {"C_2", "1", -629.6, -1e5, 0., "factor of (sigma : D) sigma"},
       {"C_3", "1", -629.6, -1e5, 1e5, "factor of sigma^2 ||D||"},
       {"C_4", "1", 1220.8, -1e5, 1e5, "factor of sigma*^2 ||D||"},
       small_pressure_constant(100.)}};

    using ProportionalHypoplasticity::ProportionalHypoplasticity;

    /// As VonWolffersdorff's.
    template <int n, typename Number>
    SymmetricComponents<n, Number>
    stress_rate(const Eigen::Matrix<Number, n, 1> &stress,
                const Number & /*void_ratio*/,
                const Eigen::Matrix<Number, n, 1> &strain,
                const Number                      &norm) const
    {
      using Stress         = SymmetricComponents<n, Number>;
      const Number tr      = trace(stress);
      const Number inverse = Number(1.) / tr;
      const Stress s       = stress * inverse;
      const Stress s_star  = s - isotropic<n>(Number(1. / 3.));
      const Number along   = Number(C_2) * double_contraction(s, strain);
      const Stress linear  = Number(C_1) * strain + along * s;
      const Stress squares =
        Number(C_3) * squared(s) + Number(C_4) * squared(s_star);
      return tr * (linear + norm * squares);
    }

    /// As stiffness_bound(); the stress has a pressure above zero.
    template <int n>
    Elasticity
    stiffness_bound_at(const Eigen::Matrix<double, n, 1> &stress,
                       const double /*void_ratio*/) const
    {
      const double                 tr     = trace(stress);
      const SymmetricComponents<n> s      = stress / tr;
      const SymmetricComponents<n> s_star = s - isotropic<n>(1. / 3.);
      HypoplasticBound bound(HypoplasticBound::deviatoric_ratio(stress));
      bound.add_identity(C_1 * tr);
      bound.add_projection(C_2 * tr);
      bound.add_nonlinear<n>(tr * (C_3 * squared(s) + C_4 * squared(s_star)));
      return bound.elasticity();
    }
  };
} // namespace Sandglass

#endif
