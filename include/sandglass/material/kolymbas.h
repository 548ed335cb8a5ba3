#ifndef sandglass_material_kolymbas_h
#define sandglass_material_kolymbas_h

#include <sandglass/material/proportional_hypoplasticity.h>

#include <cmath>

namespace Sandglass
{
  /**
   * Hypoplasticity of Kolymbas (1985), the first of these laws: with the
   * stretching D, the rate of stress is
   *
   *   C_1 (sigma D + D sigma) / 2 + C_2 (sigma : D) 1 +
   *   (C_3 sigma + C_4 sigma^2 / tr(sigma)) ||D||.
   */
  class Kolymbas : public ProportionalHypoplasticity<Kolymbas>
  {
  public:
    /// Value of the parameter Material/Model.
    static constexpr char name[] = "Kolymbas";
    /// For the documentation of that parameter.
    static constexpr char description[] =
      "the first hypoplastic law, stiffness in proportion to stress";

    /**
     * By default a material like Wu-Bauer's: the critical friction angle
     * phi = 24.9 degrees, the stress ratio 1 - sin(phi) in laterally confined
     * compression, and 150 times the pressure as initial Young's modulus. These
     * are four linear equations for the four constants. p_t as Wu-Bauer's.
     */
    static constexpr std::array<LawConstant, 5> law_constants = {
      {{"C_1", "1", -147.799, -1e5, 0., "factor of (sigma D + D sigma) / 2"},
       {"C_2", "1", -129.214, -1e5, 0., "factor of (sigma : D) 1"},
       {"C_3", "1", -31.171, -1e5, 1e5, "factor of sigma ||D||"},
       {"C_4", "1", -275.903, -1e5, 1e5, "factor of sigma^2 ||D||"},
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
      using Stress        = SymmetricComponents<n, Number>;
      const Number tr     = trace(stress);
      const Stress linear = Number(C_1) * product(stress, strain);
      const Number along  = Number(C_2) * double_contraction(stress, strain);
      const Stress nonlinear =
        Number(C_3) * stress + (Number(C_4) / tr) * squared(stress);
      return linear + isotropic<n>(along) + norm * nonlinear;
    }

    /// As stiffness_bound(); the stress has a pressure above zero.
    template <int n>
    Elasticity
    stiffness_bound_at(const Eigen::Matrix<double, n, 1> &stress,
                       const double /*void_ratio*/) const
    {
      const double     tr = trace(stress);
      HypoplasticBound bound(HypoplasticBound::deviatoric_ratio(stress));
      bound.add_product(C_1 * tr);
      bound.add_trace(C_2 * tr);
      bound.add_nonlinear<n>(C_3 * stress + C_4 / tr * squared(stress));
      return bound.elasticity();
    }
  };
} // namespace Sandglass

#endif
