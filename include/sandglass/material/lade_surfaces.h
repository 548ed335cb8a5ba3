#ifndef sandglass_material_lade_surfaces_h
#define sandglass_material_lade_surfaces_h

#include <sandglass/continuum/symmetric_products.h>
#include <sandglass/material/elasticity.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>

namespace Sandglass
{
  /**
   * Stress, compression positive and raised by the floor pressure (see
   * LadeConstants::floor_pressure), and the plastic works of cone and cap: what
   * the integration of Lade's law changes.
   */
  template <int n>
  struct LadePoint
  {
    SymmetricComponents<n> stress;
    /// Per volume in J/m^3: of the cone (expansive), of the cap (collapse).
    std::array<double, 2> work;
    /// Plastic work of the stress itself, which isn't raised.
    double dissipation;
  };

  /// Lade's constants (1977), with his letters in the comments.
  struct LadeConstants
  {
    static constexpr double atmospheric_pressure = 101325.; ///< p_a, in Pa

    double modulus_number, modulus_exponent, poisson_ratio; ///< K_ur, n, nu
    double failure, failure_exponent;                       ///< eta_1, m
    /// S, R, t: eta_2 = S f_p + R sqrt(sigma_3 / p_a) + t
    double potential_slope, potential_pressure, potential_offset;
    /// alpha, beta: 1 / q is the exponent of the hardening of the cone.
    double hardening, hardening_pressure;
    /// P, l: the work at the peak is P p_a (sigma_3 / p_a)^l.
    double peak_work, peak_work_exponent;
    double collapse, collapse_exponent; ///< C, p
    /// The share of eta_1 that f_p never falls below after the peak, and that
    /// of the cone's volumetric plastic flow which never fades.
    double residual, residual_dilation;
    /// In Pa. The law is that of Lade at a stress whose pressure is higher by
    /// this: without pressure he has neither stiffness nor strength.
    double floor_pressure;
    /// Whether the elasticity does; see LadeSurfaces::elasticity().
    bool conserves_energy;
  };

  /// Smallest principal stress and its derivative, in the plane.
  inline double
  smallest_principal_stress(const SymmetricComponents<4> &stress,
                            SymmetricComponents<4>       &gradient)
  {
    const double mean   = 0.5 * (stress[Component::xx] + stress[Component::yy]);
    const double d      = 0.5 * (stress[Component::xx] - stress[Component::yy]);
    const double t      = stress[Component::xy];
    const double radius = std::sqrt(d * d + t * t);
    if (stress[Component::zz] <= mean - radius)
      {
        gradient = {0., 0., 1., 0.};
        return stress[Component::zz];
      }
    const double cosine = radius > 0. ? d / radius : 1.;
    const double sine   = radius > 0. ? t / radius : 0.;
    gradient = {0.5 * (1. - cosine), 0.5 * (1. + cosine), 0., -0.5 * sine};
    return mean - radius;
  }

  /// As above, in space.
  inline double
  smallest_principal_stress(const SymmetricComponents<6> &stress,
                            SymmetricComponents<6>       &gradient)
  {
    Eigen::Matrix3d matrix;
    matrix << stress[0], stress[3], stress[5], //
      stress[3], stress[1], stress[4],         //
      stress[5], stress[4], stress[2];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
    const Eigen::Vector3d e = solver.eigenvectors().col(0);
    gradient << e[0] * e[0], e[1] * e[1], e[2] * e[2], e[0] * e[1], e[1] * e[2],
      e[0] * e[2];
    return solver.eigenvalues()[0];
  }

  /// The derivative of the determinant: the cofactors.
  inline SymmetricComponents<4>
  cofactors(const SymmetricComponents<4> &s)
  {
    return {s[1] * s[2], s[0] * s[2], s[0] * s[1] - s[3] * s[3], -s[3] * s[2]};
  }

  inline SymmetricComponents<6>
  cofactors(const SymmetricComponents<6> &s)
  {
    SymmetricComponents<6> result;
    result << s[1] * s[2] - s[4] * s[4], s[0] * s[2] - s[5] * s[5],
      s[0] * s[1] - s[3] * s[3], s[4] * s[5] - s[3] * s[2],
      s[3] * s[5] - s[0] * s[4], s[3] * s[4] - s[5] * s[1];
    return result;
  }

  /**
   * Both yield surfaces of Lade (1977) at one point: the cone f_p = (I1^3 / I3
   * - 27) (I1 / p_a)^m, which hardens with its plastic work, and the cap f_c =
   * I1^2 + 2 I2, the square of the stress's norm.
   *
   * An excess is positive outside a surface: (f_p - its value on the surface) /
   * eta_1 of the cone, and the norm less its value on the surface, in Pa, of
   * the cap.
   */
  template <int n>
  struct LadeSurfaces
  {
    /// What has a value for the cone and one for the cap.
    template <typename T>
    using Both = std::array<T, 2>;

    LadeSurfaces(const LadeConstants &constants, const LadePoint<n> &point)
      : constants(constants)
      , stress(point.stress)
    {
      smallest_stress = smallest_principal_stress(stress, smallest_gradient);
      first           = trace(stress);
      is_compressed   = first > 0. && smallest_stress > 0.;
      if (!is_compressed)
        return;
      set_cone(point.work[0]);
      set_cap(point.work[1]);
    }

    /**
     * E_ur = K_ur p_a (sigma_3 / p_a)^n, which gives and takes energy in cycles
     * of stress, or with a measure of stress in place of sigma_3 that is equal
     * to it without shear and conserves energy (Lade and Nelson 1987):
     * the root of (I1 / 3)^2 + 2 / 3 (1 + nu) / (1 - 2 nu) J2.
     */
    Elasticity
    elasticity() const
    {
      constexpr double p_a     = LadeConstants::atmospheric_pressure;
      const double     nu      = constants.poisson_ratio;
      double           measure = smallest_stress;
      if (constants.conserves_energy)
        measure =
          std::sqrt(first * first / 9. + 2. / 9. * (1. + nu) / (1. - 2. * nu) *
                                           squared_von_mises_stress(stress));
      return {constants.modulus_number * p_a *
                std::pow(std::max(measure, constants.floor_pressure) / p_a,
                         constants.modulus_exponent),
              nu};
    }

    const LadeConstants         &constants;
    const SymmetricComponents<n> stress;

    double                 smallest_stress, first;
    SymmetricComponents<n> smallest_gradient;
    /// Whether all principal stresses are compressive. If not, nothing below
    /// has a meaning.
    bool is_compressed;

    double       cone; ///< f_p
    Both<double> excess;
    /// How far outside is still on the surface, and how far inside already, in
    /// the excess's unit.
    Both<double> tolerance, margin;
    /// Of the excesses.
    Both<SymmetricComponents<n>> gradient;
    /// The plastic strain's, dimensionless.
    Both<SymmetricComponents<n>> flow;
    /// By how much the surface's value grows with its plastic work.
    Both<double> hardening;

  private:
    static constexpr double relative_tolerance = 1e-6, relative_margin = 1e-4;

    void
    set_cone(const double work)
    {
      constexpr double             p_a   = LadeConstants::atmospheric_pressure;
      const SymmetricComponents<n> one   = isotropic<n>(1.);
      const SymmetricComponents<n> minor = cofactors(stress);
      const double                 m     = constants.failure_exponent;
      const double                 curve = std::pow(first / p_a, m);
      const double                 third = determinant(stress);
      const double cube = first * first * first / third; // I1^3 / I3
      cone              = std::max(0., cube - 27.) * curve;

      const double value = harden(work);
      excess[0]          = (cone - value) / constants.failure;
      tolerance[0] = relative_tolerance * value / constants.failure + 1e-9;
      margin[0]    = relative_margin * value / constants.failure + 1e-9;
      gradient[0] =
        (curve * cube * (3. / first * one - minor / third) +
         m * cone / first * one - value_by_smallest * smallest_gradient) /
        constants.failure;

      // Plastic work is negative where eta_2 exceeds f_p.
      const double eta_2 = std::clamp(constants.potential_slope * cone +
                                        constants.potential_pressure *
                                          std::sqrt(smallest_stress / p_a) +
                                        constants.potential_offset,
                                      -27.,
                                      std::max(0., cone));
      const double ratio = 1. / (first * first);
      const SymmetricComponents<n> normal =
        (3. + m * eta_2 / curve * third / first * ratio) * one -
        (27. + eta_2 / curve) * ratio * minor;
      const double kept =
        std::max(constants.residual_dilation, share_after_peak);
      flow[0] = normal + (kept - 1.) / 3. * trace(normal) * one;
    }

    /**
     * The cone's value by its plastic work, eta_1 (x exp(1 - x))^(1/q) with x =
     * W_p / W_peak: what Lade's a exp(-b W_p) (W_p / p_a)^(1/q) is, if the peak
     * is eta_1. Sets what depends on it.
     */
    double
    harden(const double work)
    {
      constexpr double p_a = LadeConstants::atmospheric_pressure;
      // Under high pressure q would fall below zero.
      const double q_of_pressure =
        constants.hardening +
        constants.hardening_pressure * smallest_stress / p_a;
      const double q = std::max(1., q_of_pressure);
      const double q_gradient =
        q_of_pressure > 1. ? constants.hardening_pressure / p_a : 0.;
      const double peak =
        constants.peak_work * p_a *
        std::pow(smallest_stress / p_a, constants.peak_work_exponent);

      // The slope at no work at all is infinite.
      constexpr double smallest_share = 1e-12;
      const double     x              = std::max(smallest_share, work / peak);
      const double     share          = std::exp((std::log(x) + 1. - x) / q);
      hardening[0]                    = 0.;
      share_after_peak                = x > 1. ? share : 1.;
      value_by_smallest               = 0.;
      if (x > 1. && share <= constants.residual)
        return constants.failure * constants.residual;

      hardening[0] = share * (1. / x - 1.) / (q * peak);
      value_by_smallest =
        -constants.failure * share *
        ((std::log(x) + 1. - x) * q_gradient / (q * q) +
         constants.peak_work_exponent * (1. - x) / (q * smallest_stress));
      return constants.failure * share;
    }

    void
    set_cap(const double work)
    {
      constexpr double p_a   = LadeConstants::atmospheric_pressure;
      const double     norm  = std::sqrt(double_contraction(stress, stress));
      const double     value = p_a * std::pow(work / (constants.collapse * p_a),
                                          0.5 / constants.collapse_exponent);
      excess[1]              = norm - value;
      tolerance[1]           = relative_tolerance * value;
      margin[1]              = relative_margin * value;
      gradient[1] = flow[1] = stress / norm;
      hardening[1]          = value / (2. * constants.collapse_exponent * work);
    }

    double value_by_smallest;
    /// The cone's value over eta_1 without a residual one; one before the peak.
    double share_after_peak;
  };
} // namespace Sandglass

#endif
