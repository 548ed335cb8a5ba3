#ifndef sandglass_material_von_wolffersdorff_h
#define sandglass_material_von_wolffersdorff_h

#include <sandglass/base/exceptions.h>
#include <sandglass/base/lanes_functions.h>
#include <sandglass/material/hypoplastic.h>

#include <cmath>

namespace Sandglass
{
  /**
   * Hypoplasticity of von Wolffersdorff (1996): stiffness and strength depend
   * on pressure and void ratio, and the critical state is that of Matsuoka and
   * Nakai. With s = sigma / tr(sigma), s* its deviator, p the pressure and D
   * the stretching, the rate of stress is
   *
   *   f_s / tr(s^2) [F^2 D + a^2 (s : D) s + f_d a F (s + s*) ||D||].
   *
   * theory.md has F, f_s and f_d.
   */
  class VonWolffersdorff : public Hypoplastic<VonWolffersdorff>
  {
  public:
    /// Value of the parameter Material/Model.
    static constexpr char name[] = "von Wolffersdorff";
    /// For the documentation of that parameter.
    static constexpr char description[] =
      "hypoplasticity with the void ratio as a state variable, for sand";

    /// By default Karlsruhe fine sand (Wichtmann and Triantafyllidis 2016).
    static constexpr std::array<LawConstant, 9> law_constants = {
      {{"phi_c", "degrees", 33.1, 5., 60., "critical friction angle"},
       {"h_s", "Pa", 4e9, 1e3, 1e13, "granulate hardness"},
       {"n", "1", 0.27, 0.05, 0.95, "exponent of the granulate hardness"},
       {"e_d0", "1", 0.677, 0.01, 10., "densest void ratio without pressure"},
       {"e_c0", "1", 1.054, 0.01, 10., "critical void ratio without pressure"},
       {"e_i0", "1", 1.212, 0.01, 10., "loosest void ratio without pressure"},
       {"alpha", "1", 0.14, 0.01, 2., "exponent of density in the strength"},
       {"beta", "1", 2.5, 0., 10., "exponent of density in the stiffness"},
       small_pressure_constant(10.)}};

    explicit VonWolffersdorff(const MaterialConstants &constants)
      : Hypoplastic<VonWolffersdorff>(constants)
      , inverse_hardness(1. / law_constant<VonWolffersdorff>(constants, "h_s"))
      , n(law_constant<VonWolffersdorff>(constants, "n"))
      , e_d0(law_constant<VonWolffersdorff>(constants, "e_d0"))
      , e_c0(law_constant<VonWolffersdorff>(constants, "e_c0"))
      , e_i0(law_constant<VonWolffersdorff>(constants, "e_i0"))
      , alpha(law_constant<VonWolffersdorff>(constants, "alpha"))
      , beta(law_constant<VonWolffersdorff>(constants, "beta"))
      , a(strength_factor(law_constant<VonWolffersdorff>(constants, "phi_c")))
      , stiffness_factor(1. /
                         (n * inverse_hardness *
                          (3. + a * a -
                           std::sqrt(3.) * a *
                             std::pow((e_i0 - e_d0) / (e_c0 - e_d0), alpha))))
    {
      if (!(e_d0 < e_c0 && e_c0 < e_i0))
        throw InputError("Material",
                         "Law constants",
                         "e_d0, e_c0, e_i0",
                         "allowed are void ratios that grow in this order");
    }

    /// Density, as a share of that of unstressed material, below which grains
    /// don't touch: that of the loosest void ratio.
    double
    loosest_density_share() const
    {
      return (1. + initial_void_ratio) / (1. + e_i0);
    }

    /**
     * The rate of stress times the duration of a strain increment.
     *
     * @param stress  in Pa, with a pressure above zero.
     * @param strain,norm  the increment and its norm.
     * @return in Pa.
     */
    template <int n_components, typename Number>
    SymmetricComponents<n_components, Number>
    stress_rate(const Eigen::Matrix<Number, n_components, 1> &stress,
                const Number                                 &void_ratio,
                const Eigen::Matrix<Number, n_components, 1> &strain,
                const Number                                 &norm) const
    {
      using Stress            = SymmetricComponents<n_components, Number>;
      const Number tr         = trace(stress);
      const Stress s          = stress * (Number(1.) / tr);
      const Stress s_star     = s - isotropic<n_components>(Number(1. / 3.));
      const Number square     = double_contraction(s_star, s_star);
      const Number F          = matsuoka_nakai(s_star, square);
      const Factors<Number> f = density_factors(-tr, void_ratio);

      const Number scale     = f.stiffness / (square + Number(1. / 3.));
      const Number nonlinear = scale * f.density * Number(a) * F * norm;
      const Number linear =
        scale * Number(a * a) * double_contraction(s, strain);
      return (scale * F * F) * strain + (linear + nonlinear) * s +
             nonlinear * s_star;
    }

    /// As stiffness_bound(); the stress has a pressure above zero.
    template <int n_components>
    Elasticity
    stiffness_bound_at(const Eigen::Matrix<double, n_components, 1> &stress,
                       const double void_ratio) const
    {
      using Stress                    = SymmetricComponents<n_components>;
      const double          tr        = trace(stress);
      const Stress          s         = stress / tr;
      const Stress          s_star    = deviator(s);
      const double          square    = double_contraction(s_star, s_star);
      const double          F         = matsuoka_nakai(s_star, square);
      const Factors<double> f         = density_factors(-tr, void_ratio);
      const double          scale     = f.stiffness / (square + 1. / 3.);
      const double          nonlinear = scale * f.density * a * F;

      HypoplasticBound bound(std::sqrt(square));
      bound.add_identity(scale * F * F);
      bound.add_projection(scale * a * a);
      bound.add_nonlinear<n_components>(nonlinear * (s + s_star));
      return bound.elasticity();
    }

  private:
    /// Of pressure and density.
    template <typename Number>
    struct Factors
    {
      Number stiffness; ///< f_s in Pa
      Number density;   ///< f_d
    };

    /// a = sqrt(3) (3 - sin(phi_c)) / (2 sqrt(2) sin(phi_c)).
    static double
    strength_factor(const double degrees)
    {
      const double sine = std::sin(radians(degrees));
      return std::sqrt(3.) * (3. - sine) / (2. * std::sqrt(2.) * sine);
    }

    /**
     * F = sqrt(t^2 / 8 + (2 - t^2) / (2 + sqrt(2) t cos(3 theta))) -
     * t / (2 sqrt(2)), where t = sqrt(3) ||s*||. With the determinant of s*,
     * tr(s*^3) / 3, sqrt(2) t cos(3 theta) is -18 det(s*) / ||s*||^2.
     *
     * The quotient lies between 0 and 2 while no stress is tensile, and is held
     * there beyond.
     */
    template <int n_components, typename Number>
    static Number
    matsuoka_nakai(const Eigen::Matrix<Number, n_components, 1> &s_star,
                   const Number                                 &square)
    {
      using std::sqrt;
      const Number numerator   = Number(2.) - Number(3.) * square;
      const Number denominator = Number(2.) - Number(18.) *
                                                determinant(s_star) /
                                                (square + Number(1e-30));
      const Number above_zero =
        select(numerator < Number(0.), Number(0.), numerator);
      const Number half = Number(0.5) * above_zero;
      const Number denominator_held =
        select(denominator < half, half + Number(1e-30), denominator);
      return sqrt(Number(3. / 8.) * square + above_zero / denominator_held) -
             sqrt(Number(3. / 8.) * square);
    }

    /**
     * With x = 3 p / h_s and the limits e_d, e_c, e_i of the void ratio, all in
     * proportion to exp(-x^n):
     *
     *   f_s = h_s / n (e_i / e)^beta (1 + e_i) / e_i x^(1 - n) / [3 + a^2 -
     *         sqrt(3) a ((e_i0 - e_d0) / (e_c0 - e_d0))^alpha],
     *   f_d = ((e - e_d) / (e_c - e_d))^alpha.
     *
     * The void ratio is held between its limits, and x below 1: there grains
     * would be crushed, and e_i goes to zero.
     *
     * @param three_p  3 p in Pa.
     */
    template <typename Number>
    Factors<Number>
    density_factors(const Number &three_p, const Number &void_ratio) const
    {
      const Number share  = three_p * Number(inverse_hardness);
      const Number x      = select(share > Number(1.), Number(1.), share);
      const Number x_to_n = power(x, Number(n));
      const Number growth = exponential(x_to_n); // e_i0 / e_i, e_d0 / e_d, ...

      // The void ratio that it would have without pressure.
      Number e = void_ratio * growth;
      e        = select(e < Number(e_d0), Number(e_d0), e);
      e        = select(e > Number(e_i0), Number(e_i0), e);
      return {Number(stiffness_factor) * power(Number(e_i0) / e, Number(beta)) *
                (Number(1.) + growth * Number(1. / e_i0)) * (x / x_to_n),
              power((e - Number(e_d0)) * Number(1. / (e_c0 - e_d0)),
                    Number(alpha))};
    }

    const double inverse_hardness; ///< 1 / h_s in 1/Pa
    const double n, e_d0, e_c0, e_i0, alpha, beta;
    const double a;
    const double stiffness_factor; ///< of f_s: what doesn't depend on state
  };
} // namespace Sandglass

#endif
