#ifndef sandglass_material_hypoplastic_bound_h
#define sandglass_material_hypoplastic_bound_h

#include <sandglass/material/elasticity.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  /**
   * Bound of a form D : H(D) that a hypoplastic law has at some state, H(D)
   * being the rate of stress, by that of an isotropic elasticity,
   * 3 K m^2 + 2 G d^2, where m = tr D / sqrt(3) and d = ||dev D||. Terms are
   * added one by one, each with its factor in Pa.
   *
   * The stress takes part as sigma / tr(sigma), whose deviator has the norm r.
   */
  class HypoplasticBound
  {
  public:
    explicit HypoplasticBound(const double r)
      : r(r)
    {}

    /// factor D : D
    void
    add_identity(const double factor)
    {
      add(std::abs(factor), std::abs(factor));
    }

    /**
     * factor (s : D)^2 with s = sigma / tr(sigma): at most (m / sqrt(3) + r
     * d)^2, and the mixed term 2 m d is at most m^2 + d^2.
     */
    void
    add_projection(const double factor)
    {
      const double largest = std::abs(factor) * (root_third + r);
      add(largest * root_third, largest * r);
    }

    /// factor (s D) : D: at most the largest principal value of s.
    void
    add_product(const double factor)
    {
      add_identity(factor * (1. / 3. + std::sqrt(2. / 3.) * r));
    }

    /// factor (s : D) tr(D)
    void
    add_trace(const double factor)
    {
      const double mixed = 0.5 * std::sqrt(3.) * r;
      add(std::abs(factor) * (1. + mixed), std::abs(factor) * mixed);
    }

    /// ||D|| N : D with N = `nonlinear` in Pa. With its parts along m and d,
    /// m ||D|| is at most m^2 + d^2 / 2, and d ||D|| at most d^2 + m^2 / 2.
    template <int n>
    void
    add_nonlinear(const SymmetricComponents<n> &nonlinear)
    {
      const double along_m = root_third * std::abs(trace(nonlinear));
      const SymmetricComponents<n> along_d = deviator(nonlinear);
      const double b = std::sqrt(double_contraction(along_d, along_d));
      add(along_m + 0.5 * b, b + 0.5 * along_m);
    }

    /// Of a stress, r = ||deviator|| / |trace|.
    template <int n>
    static double
    deviatoric_ratio(const Eigen::Matrix<double, n, 1> &stress)
    {
      const SymmetricComponents<n> s = deviator(stress);
      return std::sqrt(double_contraction(s, s)) / std::abs(trace(stress));
    }

    /// With a Poisson's ratio that isn't negative.
    Elasticity
    elasticity() const
    {
      Elasticity result(1., 0.);
      result.shear_modulus = 0.5 * deviatoric;
      result.lame_modulus =
        std::max(0., (volumetric - 2. * result.shear_modulus) / 3.);
      return result;
    }

  private:
    void
    add(const double on_m, const double on_d)
    {
      volumetric += on_m;
      deviatoric += on_d;
    }

    static constexpr double root_third = 0.57735026918962576451;

    const double r;
    double       volumetric = 0.; ///< 3 K in Pa
    double       deviatoric = 0.; ///< 2 G in Pa
  };
} // namespace Sandglass

#endif
