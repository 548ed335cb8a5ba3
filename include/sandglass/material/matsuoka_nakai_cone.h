#ifndef sandglass_material_matsuoka_nakai_cone_h
#define sandglass_material_matsuoka_nakai_cone_h

#include <sandglass/continuum/symmetric_products.h>
#include <sandglass/material/circular_cone.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Sandglass
{
  /// cos(2/3 arccos(w)) for 0 <= w <= 1, within 2e-11: it has no singularity
  /// but at w = -1, so few terms do.
  template <typename Number>
  Number
  cosine_of_two_thirds(const Number &w)
  {
    // Interpolates at Chebyshev's points, in powers of x.
    constexpr std::array<double, 12> coefficients = {{0.766044443127552,
                                                      0.2474090663203153,
                                                      -0.015509189053053249,
                                                      0.002466352997575898,
                                                      -0.0005041175435096118,
                                                      0.00011642333764469613,
                                                      -2.895003368307985e-05,
                                                      7.549983726996081e-06,
                                                      -1.979265754829334e-06,
                                                      5.474106122650974e-07,
                                                      -2.072221432805085e-07,
                                                      5.994733584263491e-08}};
    const Number                     x            = Number(2.) * w - Number(1.);
    const auto                       pair         = [&](const unsigned int i) {
      return Number(coefficients[i]) + Number(coefficients[i + 1]) * x;
    };
    // Not one after the other, as Horner's rule: the processor waits less.
    const Number x2     = x * x;
    const Number x4     = x2 * x2;
    const Number low    = pair(0) + x2 * pair(2);
    const Number middle = pair(4) + x2 * pair(6);
    const Number high   = pair(8) + x2 * pair(10);
    return low + x4 * (middle + x4 * high);
  }

  /**
   * Matsuoka and Nakai's cone I1 I2 / I3 = (9 - sin^2(phi)) / (1 - sin^2(phi))
   * of the stress less its value at the apex (matsuoka1974). It is smooth, and
   * passes through the edges of Mohr and Coulomb's pyramid, so that phi acts in
   * triaxial compression as in extension.
   *
   * A deviator x s of growing size x reaches the cone where the cubic
   * (k - 9) u^3 - (k - 3) u - k J3 / J2^(3/2) = 0 holds for u = p / (x
   * sqrt(J2)). Its largest root is 2 r cos(alpha / 3) with cos(alpha) linear in
   * J3 / J2^(3/2).
   */
  class MatsuokaNakaiCone
  {
  public:
    MatsuokaNakaiCone() = default;

    /**
     * @param friction_angle  phi in rad, greater than 0.
     * @param cohesion        c in Pa.
     */
    MatsuokaNakaiCone(const double friction_angle, const double cohesion)
      : tensile_pressure(cohesion / std::tan(friction_angle))
    {
      const double sine = std::sin(friction_angle), square = sine * sine;
      const double k       = (9. - square) / (1. - square);
      const double k_less9 = 8. * square / (1. - square);
      const double r       = std::sqrt((k - 3.) / (3. * k_less9));
      per_invariant        = k / (2. * k_less9 * r * r * r);
      per_cube             = std::sqrt(27.) * per_invariant;
      smallest_slope       = std::sqrt(3.) / (2. * r);
      compression          = 6. * sine / (3. - sine);
    }

    /// Largest q in the direction of a deviator, at a pressure in Pa.
    template <int n, typename Number>
    DeviatorLimit<Number>
    largest_deviator(const Number                      &pressure,
                     const Eigen::Matrix<Number, n, 1> &deviator,
                     const Number &squared_von_mises_stress) const
    {
      return {Number(smallest_slope) * (pressure + Number(tensile_pressure)),
              root(deviator, squared_von_mises_stress)};
    }

    /// Derivative of largest_deviator() with respect to the stress.
    template <int n>
    SymmetricComponents<n>
    gradient(const double                       pressure,
             const Eigen::Matrix<double, n, 1> &deviator) const
    {
      const double J2     = 0.5 * double_contraction(deviator, deviator);
      const double root   = this->root(deviator, 3. * J2);
      const double height = smallest_slope * (pressure + tensile_pressure);
      // dt of t = per_invariant J3 J2^(-3/2), then 4 c^3 - 3 c = t.
      const double           t_scale = per_invariant / std::pow(J2, 1.5);
      SymmetricComponents<n> t_gradient =
        t_scale * (squared(deviator) - isotropic<n>(2. / 3. * J2) -
                   1.5 * determinant(deviator) / J2 * deviator);
      for (int c = Component::first_shear; c < n; ++c)
        t_gradient[c] *= 2.;
      const double root_by_t = 1. / std::max(12. * root * root - 3., 1e-6);
      return isotropic<n>(-smallest_slope / (3. * root)) -
             height / (root * root) * root_by_t * t_gradient;
    }

    /// Slope of q over p where the material is compressed along one axis.
    double
    slope_in_compression() const
    {
      return compression;
    }

    /// c cot(phi) in Pa, the tension at the apex.
    double tensile_pressure = 0.;

  private:
    /// cos(alpha / 3), from 1/2 to 1.
    template <int n, typename Number>
    Number
    root(const Eigen::Matrix<Number, n, 1> &deviator,
         const Number                      &squared_von_mises_stress) const
    {
      using std::sqrt;
      constexpr double smallest_cube = 1e-200; // in Pa^3; avoids 0 / 0

      const Number cosine =
        Number(per_cube) * determinant(deviator) /
        (squared_von_mises_stress * sqrt(squared_von_mises_stress) +
         Number(smallest_cube));
      // A deviator that is nothing but rounding may lie beyond.
      const Number half_square = Number(0.5) * (Number(1.) + cosine);
      return cosine_of_two_thirds(
        sqrt(select(half_square > Number(0.), half_square, Number(0.))));
    }

    double per_invariant  = 0.; ///< cos(alpha) / (J3 / J2^(3/2))
    double per_cube       = 0.; ///< the same by J3 / q^3
    double smallest_slope = 0.; ///< of q over p where cos(alpha / 3) is 1
    double compression    = 0.;
  };
} // namespace Sandglass

#endif
