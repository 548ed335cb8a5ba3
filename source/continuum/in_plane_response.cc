#include <sandglass/continuum/in_plane_response.h>
#include <sandglass/continuum/midpoint_stress_derivative.h>

namespace Sandglass
{
  namespace
  {
    namespace G = GradientComponent;
    namespace S = Component;

    using Matrix4x5 = Eigen::Matrix<double, 4, 5>;
    using Matrix5x4 = Eigen::Matrix<double, 5, 4>;

    /// Derivative of the stress at the end of the step with respect to H.
    Matrix4x5
    stress_derivative(const SymmetricComponents<4> &stress_before,
                      const MaterialTangent<4>     &material)
    {
      // H_yx = 1 alone is a shear strain of 1/2 and a spin of 1/2
      const SymmetricComponents<4> turned =
        material.by_stress * jaumann_rotation(stress_before, 0.5);
      const SymmetricComponents<4> sheared =
        0.5 * material.by_strain.col(S::xy);

      Matrix4x5 derivative;
      derivative.col(G::xx)   = material.by_strain.col(S::xx);
      derivative.col(G::yy)   = material.by_strain.col(S::yy);
      derivative.col(G::hoop) = material.by_strain.col(S::zz);
      derivative.col(G::xy)   = sheared - turned;
      derivative.col(G::yx)   = sheared + turned;
      return derivative;
    }



    /// Derivative of the Piola stress with respect to the stress at fixed H.
    Matrix5x4
    stress_sensitivity(const Gradient5 &H)
    {
      const Eigen::Matrix2d cofactor  = InPlaneResponse::in_plane_cofactor(H);
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
    geometric_tangent(const SymmetricComponents<4> &stress, const Gradient5 &H)
    {
      const Eigen::Matrix2d cofactor = InPlaneResponse::in_plane_cofactor(H);
      const double          stretch  = 1. + H[G::hoop];
      const double          xx       = stretch * stress[S::xx];
      const double          yy       = stretch * stress[S::yy];
      const double          xy       = stretch * stress[S::xy];
      const double          zz       = stress[S::zz];
      Eigen::Matrix2d       P;
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
  InPlaneResponse::tangent(const SymmetricComponents<4> &stress_before,
                           const SymmetricComponents<4> &stress,
                           const Gradient5              &H,
                           const MaterialTangent<4>     &material,
                           const StressIntegration       integration)
  {
    const Matrix4x5 derivative =
      integration == StressIntegration::start_of_step ?
        stress_derivative(stress_before, material) :
        midpoint_stress_derivative<InPlaneResponse>(stress_before, H, material);
    return geometric_tangent(stress, H) + stress_sensitivity(H) * derivative;
  }
} // namespace Sandglass
