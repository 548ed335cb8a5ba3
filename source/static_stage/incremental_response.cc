#include <sandglass/static_stage/incremental_response.h>

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

    /// Derivative of the trial stress with respect to H.
    Matrix4x5
    trial_stress_derivative(const Elasticity       &elasticity,
                            const SymmetricTensor4 &stress_before)
    {
      // H_yx = 1 alone is a shear strain of 1/2 and a spin of 1/2
      const SymmetricTensor4 shear_stress(0., 0., 0., elasticity.shear_modulus);
      const SymmetricTensor4 rotation = jaumann_rotation(stress_before, 0.5);
      const double           lambda   = elasticity.lame_modulus;
      const double           confined = elasticity.confined_modulus();

      Matrix4x5 derivative;
      derivative.col(G::xx) << confined, lambda, lambda, 0.;
      derivative.col(G::yy) << lambda, confined, lambda, 0.;
      derivative.col(G::hoop) << lambda, lambda, confined, 0.;
      derivative.col(G::xy) = shear_stress - rotation;
      derivative.col(G::yx) = shear_stress + rotation;
      return derivative;
    }



    /// Derivative of the Piola stress with respect to the stress at fixed H.
    Matrix5x4
    stress_sensitivity(const Gradient5 &H)
    {
      const Eigen::Matrix2d cofactor =
        IncrementalResponse::in_plane_cofactor(H);
      const Eigen::Matrix2d stretched = (1. + H[G::hoop]) * cofactor;

      Matrix5x4 derivative;
      derivative.row(G::xx) << stretched(0, 0), 0., 0., stretched(1, 0);
      derivative.row(G::xy) << stretched(0, 1), 0., 0., stretched(1, 1);
      derivative.row(G::yx) << 0., stretched(1, 0), 0., stretched(0, 0);
      derivative.row(G::yy) << 0., stretched(1, 1), 0., stretched(0, 1);
      derivative.row(G::hoop) << 0., 0., cofactor.determinant(), 0.;
      return derivative;
    }



    /// Derivative of the Piola stress with respect to H at fixed stress.
    Matrix5
    geometric_tangent(const SymmetricTensor4 &stress, const Gradient5 &H)
    {
      const Eigen::Matrix2d cofactor =
        IncrementalResponse::in_plane_cofactor(H);
      const double    stretch = 1. + H[G::hoop];
      const double    xx      = stretch * stress[S::xx];
      const double    yy      = stretch * stress[S::yy];
      const double    xy      = stretch * stress[S::xy];
      const double    zz      = stress[S::zz];
      Eigen::Matrix2d P;
      P << stress[S::xx], stress[S::xy], stress[S::xy], stress[S::yy];
      P *= cofactor;

      // in-plane rows: stretch * stress * cofactor(H); hoop row: stress_zz *
      // det(in-plane F), whose derivative is the cofactor
      Matrix5 derivative;
      derivative.row(G::xx) << 0., -xy, 0., xx, P(0, 0);
      derivative.row(G::xy) << xy, 0., -xx, 0., P(0, 1);
      derivative.row(G::yx) << 0., -yy, 0., xy, P(1, 0);
      derivative.row(G::yy) << yy, 0., -xy, 0., P(1, 1);
      derivative.row(G::hoop) << zz * cofactor(0, 0), zz * cofactor(0, 1),
        zz * cofactor(1, 0), zz * cofactor(1, 1), 0.;
      return derivative;
    }
  } // namespace



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
