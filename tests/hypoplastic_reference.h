#ifndef sandglass_tests_hypoplastic_reference_h
#define sandglass_tests_hypoplastic_reference_h

#include <sandglass/material/kolymbas.h>
#include <sandglass/material/von_wolffersdorff.h>
#include <sandglass/material/wu_bauer.h>

#include <Eigen/Dense>

#include <cmath>

/**
 * The hypoplastic laws as they are printed: with matrices and the system's
 * functions, for the standard constants. And an integration of a law in many
 * small steps.
 */
namespace HypoplasticReference
{
  using namespace Sandglass;
  using Matrix = Eigen::Matrix3d;

  inline Matrix
  matrix(const SymmetricComponents<6> &a)
  {
    Matrix result;
    result << a[0], a[3], a[5], a[3], a[1], a[4], a[5], a[4], a[2];
    return result;
  }

  inline SymmetricComponents<6>
  components(const Matrix &a)
  {
    SymmetricComponents<6> result;
    result << a(0, 0), a(1, 1), a(2, 2), a(0, 1), a(1, 2), a(0, 2);
    return result;
  }

  /// Like the law's constant, by name.
  template <typename Law>
  double
  constant(const char *const name)
  {
    return law_constant<Law>(MaterialConstants{}, name);
  }

  inline Matrix
  stress_rate(const VonWolffersdorff &,
              const Matrix &stress,
              const double  e,
              const Matrix &D)
  {
    const auto get = [](const char *const name) {
      return constant<VonWolffersdorff>(name);
    };
    const double sine  = std::sin(get("phi_c") * M_PI / 180.);
    const double a     = std::sqrt(3.) * (3. - sine) / (std::sqrt(8.) * sine);
    const double x     = -stress.trace() / get("h_s");
    const double ratio = std::exp(-std::pow(x, get("n")));
    const double e_d = ratio * get("e_d0"), e_c = ratio * get("e_c0"),
                 e_i = ratio * get("e_i0");
    const double f_d = std::pow((e - e_d) / (e_c - e_d), get("alpha"));
    const double f_s =
      get("h_s") / get("n") * std::pow(e_i / e, get("beta")) * (1. + e_i) /
      e_i * std::pow(x, 1. - get("n")) /
      (3. + a * a -
       std::sqrt(3.) * a *
         std::pow((get("e_i0") - get("e_d0")) / (get("e_c0") - get("e_d0")),
                  get("alpha")));

    const Matrix s           = stress / stress.trace();
    const Matrix s_star      = s - Matrix::Identity() / 3.;
    const double tan_psi     = std::sqrt(3.) * s_star.norm();
    const double cos_3_theta = -std::sqrt(6.) *
                               (s_star * s_star * s_star).trace() /
                               std::pow((s_star * s_star).trace(), 1.5);
    const double F = std::sqrt(tan_psi * tan_psi / 8. +
                               (2. - tan_psi * tan_psi) /
                                 (2. + std::sqrt(2.) * tan_psi * cos_3_theta)) -
                     tan_psi / std::sqrt(8.);
    return f_s / (s * s).trace() *
           (F * F * D + a * a * (s * D).trace() * s +
            f_d * a * F * (s + s_star) * D.norm());
  }

  inline Matrix
  stress_rate(const WuBauer &, const Matrix &stress, double, const Matrix &D)
  {
    const double tr     = stress.trace();
    const Matrix s_star = stress - tr / 3. * Matrix::Identity();
    return constant<WuBauer>("C_1") * tr * D +
           constant<WuBauer>("C_2") * (stress * D).trace() / tr * stress +
           (constant<WuBauer>("C_3") * stress * stress +
            constant<WuBauer>("C_4") * s_star * s_star) *
             D.norm() / tr;
  }

  inline Matrix
  stress_rate(const Kolymbas &, const Matrix &stress, double, const Matrix &D)
  {
    return constant<Kolymbas>("C_1") / 2. * (stress * D + D * stress) +
           constant<Kolymbas>("C_2") * (stress * D).trace() *
             Matrix::Identity() +
           constant<Kolymbas>("C_3") * D.norm() * stress +
           constant<Kolymbas>("C_4") * D.norm() / stress.trace() * stress *
             stress;
  }

  /// A law's correct() by n_steps steps of Runge and Kutta's method of fourth
  /// order. Where pressure ends, the stress is zero; the deviator is bounded.
  template <typename Law>
  void
  integrate(const Law                    &law,
            SymmetricComponents<6>       &stress,
            double                       &e,
            const SymmetricComponents<6> &increment,
            const unsigned int            n_steps)
  {
    using Stress        = SymmetricComponents<6>;
    const double p_t    = law.small_pressure;
    const auto   inside = [p_t](const Stress &shifted) -> Stress {
      const double p = pressure(shifted);
      const Stress s = deviator(shifted);
      const double limit =
        std::sqrt(6.) * p / std::sqrt(double_contraction(s, s));
      return p <= p_t   ? Stress(isotropic<6>(-p_t)) :
               limit < 1. ? Stress(limit * s - isotropic<6>(p)) :
                            shifted;
    };
    const Stress strain  = increment / n_steps;
    const double norm    = std::sqrt(double_contraction(strain, strain));
    const double change  = trace(strain);
    Stress       shifted = inside(stress - isotropic<6>(p_t));
    for (unsigned int i = 0; i < n_steps; ++i)
      {
        const auto rate = [&](const Stress &at, const double share) -> Stress {
          return law.stress_rate(inside(at),
                                 (1. + e) * std::exp(share * change) - 1.,
                                 strain,
                                 norm);
        };
        const Stress k1 = rate(shifted, 0.);
        const Stress k2 = rate(shifted + 0.5 * k1, 0.5);
        const Stress k3 = rate(shifted + 0.5 * k2, 0.5);
        const Stress k4 = rate(shifted + k3, 1.);
        shifted         = inside(shifted + (k1 + 2. * k2 + 2. * k3 + k4) / 6.);
        e               = (1. + e) * std::exp(change) - 1.;
      }
    stress = shifted + isotropic<6>(p_t);
  }
} // namespace HypoplasticReference

#endif
