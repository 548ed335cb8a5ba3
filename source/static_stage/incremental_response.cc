#include <sandglass/static_stage/incremental_response.h>

#include <Eigen/LU>

#include <algorithm>

namespace Sandglass
{
  namespace
  {
    namespace G = GradientComponent;
    namespace S = Component;

    /**
     * Share of the elastic stiffness that separated points keep in the tangent
     * (not in the forces). Without it, a node all of whose cells are separated
     * would have an equation of zeros.
     */
    constexpr double separated_stiffness = 1e-3;

    using Matrix4x5 = Eigen::Matrix<double, 4, 5>;
    using Matrix5x4 = Eigen::Matrix<double, 5, 4>;

    /// Counterclockwise, (dv/dx - du/dy) / 2 of the displacement increment.
    double
    spin(const Gradient5 &H)
    {
      return (H[G::yx] - H[G::xy]) / 2.;
    }



    SymmetricTensor4
    symmetric_part(const Gradient5 &H)
    {
      return {H[G::xx], H[G::yy], H[G::hoop], (H[G::xy] + H[G::yx]) / 2.};
    }



    /// The in-plane part of F's cofactor, det(F) F^-T without the hoop factor,
    /// is linear in F.
    Eigen::Matrix2d
    in_plane_cofactor(const Gradient5 &H)
    {
      Eigen::Matrix2d cofactor;
      cofactor << 1. + H[G::yy], -H[G::yx], -H[G::xy], 1. + H[G::xx];
      return cofactor;
    }



    Eigen::Matrix2d
    in_plane(const SymmetricTensor4 &stress)
    {
      Eigen::Matrix2d matrix;
      matrix << stress[S::xx], stress[S::xy], stress[S::xy], stress[S::yy];
      return matrix;
    }



    /// Derivative of the trial stress with respect to H.
    Matrix4x5
    trial_stress_derivative(const Elasticity       &elasticity,
                            const SymmetricTensor4 &stress_before)
    {
      Matrix4x5 derivative;
      for (int i = 0; i < 5; ++i)
        derivative.col(i) =
          IncrementalResponse::trial_stress(elasticity,
                                            stress_before,
                                            Gradient5::Unit(i)) -
          stress_before;
      return derivative;
    }



    /// Derivative of the Piola stress with respect to the stress at fixed H.
    Matrix5x4
    stress_sensitivity(const Gradient5 &H)
    {
      Matrix5x4 derivative;
      for (int i = 0; i < 4; ++i)
        derivative.col(i) =
          IncrementalResponse::piola_stress(SymmetricTensor4::Unit(i), H);
      return derivative;
    }



    /// Derivative of the Piola stress with respect to H at fixed stress.
    Matrix5
    geometric_tangent(const SymmetricTensor4 &stress, const Gradient5 &H)
    {
      Matrix5               derivative = Matrix5::Zero();
      const double          stretch    = 1. + H[G::hoop];
      const Eigen::Matrix2d cofactor   = in_plane_cofactor(H);
      const Eigen::Matrix2d P          = in_plane(stress) * cofactor;

      // in-plane rows: stretch * stress * cofactor(H)
      const auto in_plane_rows = [&](const Eigen::Matrix2d &change,
                                     int                    column) {
        derivative(G::xx, column) = change(0, 0);
        derivative(G::xy, column) = change(0, 1);
        derivative(G::yx, column) = change(1, 0);
        derivative(G::yy, column) = change(1, 1);
      };
      for (const int i : {G::xx, G::xy, G::yx, G::yy})
        in_plane_rows(stretch * in_plane(stress) *
                        (in_plane_cofactor(Gradient5::Unit(i)) -
                         Eigen::Matrix2d::Identity()),
                      i);
      in_plane_rows(P, G::hoop);

      // hoop row: stress_zz * det(in-plane F), whose derivative is the cofactor
      const double hoop_stress   = stress[S::zz];
      derivative(G::hoop, G::xx) = hoop_stress * cofactor(0, 0);
      derivative(G::hoop, G::xy) = hoop_stress * cofactor(0, 1);
      derivative(G::hoop, G::yx) = hoop_stress * cofactor(1, 0);
      derivative(G::hoop, G::yy) = hoop_stress * cofactor(1, 1);
      return derivative;
    }
  } // namespace



  double
  IncrementalResponse::volume_ratio(const Gradient5 &H)
  {
    return in_plane_cofactor(H).determinant() * (1. + H[G::hoop]);
  }



  SymmetricTensor4
  IncrementalResponse::trial_stress(const Elasticity       &elasticity,
                                    const SymmetricTensor4 &stress_before,
                                    const Gradient5        &H)
  {
    return stress_before + jaumann_rotation(stress_before, spin(H)) +
           elasticity.stress(symmetric_part(H));
  }



  Gradient5
  IncrementalResponse::piola_stress(const SymmetricTensor4 &stress,
                                    const Gradient5        &H)
  {
    const Eigen::Matrix2d cofactor = in_plane_cofactor(H);
    const Eigen::Matrix2d P = (1. + H[G::hoop]) * in_plane(stress) * cofactor;
    Gradient5             result;
    result << P(0, 0), P(0, 1), P(1, 0), P(1, 1),
      stress[S::zz] * cofactor.determinant();
    return result;
  }



  Matrix5
  IncrementalResponse::tangent(const Elasticity       &elasticity,
                               const SymmetricTensor4 &stress_before,
                               const SymmetricTensor4 &stress,
                               const Gradient5        &H,
                               const Eigen::Matrix4d  &projection_derivative)
  {
    return geometric_tangent(stress, H) +
           stress_sensitivity(H) * projection_derivative *
             trial_stress_derivative(elasticity, stress_before);
  }



  Eigen::Matrix4d
  IncrementalResponse::stabilized_projection_derivative(
    const DruckerPrager    &material,
    const SymmetricTensor4 &trial_stress,
    const double            elastic_share)
  {
    const Eigen::Matrix4d identity = Eigen::Matrix4d::Identity();
    if (trial_stress.isZero(0.))
      {
        // The apex of the cone. Laterally confined compression, elastic with
        // q / p = 2 G / K, leaves it along the yield surface if that is
        // steeper: take its secant, which scales the deviator.
        const double ratio =
          std::min(1.,
                   material.yield_slope * material.elasticity.bulk_modulus() /
                     (2. * material.elasticity.shear_modulus));
        const SymmetricTensor4 one(1., 1., 1., 0.);
        return ratio * identity + (1. - ratio) / 3. * one * one.transpose();
      }
    if (pressure(trial_stress) <= 0.)
      return std::max(separated_stiffness, elastic_share) * identity;
    return (1. - elastic_share) * material.projection_derivative(trial_stress) +
           elastic_share * identity;
  }
} // namespace Sandglass
