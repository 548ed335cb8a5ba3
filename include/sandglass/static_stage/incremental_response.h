#ifndef sandglass_static_stage_incremental_response_h
#define sandglass_static_stage_incremental_response_h

#include <sandglass/material/drucker_prager.h>

#include <Eigen/Core>
#include <Eigen/LU>

namespace Sandglass
{
  /**
   * A gradient that isn't symmetric, in the components that plane strain and
   * axisymmetry leave: (xx, xy, yx, yy, hoop), where xy is the derivative of
   * the x component with respect to y. Plane strain has zero hoop components.
   */
  using Gradient5 = Eigen::Matrix<double, 5, 1>;
  using Matrix5   = Eigen::Matrix<double, 5, 5>;

  namespace GradientComponent
  {
    enum : int
    {
      xx   = 0,
      xy   = 1,
      yx   = 2,
      yy   = 3,
      hoop = 4
    };
  }

  /**
   * What a load step of the updated Lagrangian formulation does to a material
   * point. The configuration at the start of the step is the reference: H is
   * the gradient of the displacement increment with respect to it, F = I + H
   * the increment's deformation gradient, J = det(F).
   */
  namespace IncrementalResponse
  {
    /// The in-plane part of F's cofactor, det(F) F^-T without the hoop factor;
    /// it is linear in F.
    inline Eigen::Matrix2d
    in_plane_cofactor(const Gradient5 &H)
    {
      namespace G = GradientComponent;
      Eigen::Matrix2d cofactor;
      cofactor << 1. + H[G::yy], -H[G::yx], -H[G::xy], 1. + H[G::xx];
      return cofactor;
    }

    /// J, current volume over volume at the start of the step.
    inline double
    volume_ratio(const Gradient5 &H)
    {
      return in_plane_cofactor(H).determinant() *
             (1. + H[GradientComponent::hoop]);
    }

    /**
     * Elastic trial stress after the increment, by the forward-Euler rule of
     * Section 4.1 of the paper with strain increment sym(H) and spin skew(H).
     */
    inline SymmetricTensor4
    trial_stress(const Elasticity       &elasticity,
                 const SymmetricTensor4 &stress_before,
                 const Gradient5        &H)
    {
      namespace G = GradientComponent;
      const SymmetricTensor4 strain(H[G::xx],
                                    H[G::yy],
                                    H[G::hoop],
                                    (H[G::xy] + H[G::yx]) / 2.);
      const double           spin = (H[G::yx] - H[G::xy]) / 2.;
      return stress_before + jaumann_rotation(stress_before, spin) +
             elasticity.stress(strain);
    }

    /**
     * First Piola-Kirchhoff stress J sigma F^-T in Pa: what the virtual
     * displacement's gradient in the reference configuration works on.
     */
    inline Gradient5
    piola_stress(const SymmetricTensor4 &stress, const Gradient5 &H)
    {
      namespace S                    = Component;
      const Eigen::Matrix2d cofactor = in_plane_cofactor(H);
      Eigen::Matrix2d       in_plane;
      in_plane << stress[S::xx], stress[S::xy], stress[S::xy], stress[S::yy];
      const Eigen::Matrix2d P =
        (1. + H[GradientComponent::hoop]) * in_plane * cofactor;
      Gradient5 result;
      result << P(0, 0), P(0, 1), P(1, 0), P(1, 1),
        stress[S::zz] * cofactor.determinant();
      return result;
    }

    /**
     * Consistent tangent: the derivative of the first Piola-Kirchhoff stress
     * with respect to H, for a stress that is the projection of the trial
     * stress onto the yield surface.
     *
     * @param projection_derivative  derivative of that projection.
     */
    Matrix5
    tangent(const Elasticity       &elasticity,
            const SymmetricTensor4 &stress_before,
            const SymmetricTensor4 &stress,
            const Gradient5        &H,
            const Eigen::Matrix4d  &projection_derivative);

    /**
     * DruckerPrager::projection_derivative() as Newton's method uses it, for
     * points where that is zero or doesn't exist.
     *
     * @param elastic_share  from 0, the derivative, to 1, the identity, which
     *                       gives the elastic stiffness.
     */
    Eigen::Matrix4d
    stabilized_projection_derivative(const DruckerPrager    &material,
                                     const SymmetricTensor4 &trial_stress,
                                     const double            elastic_share);
  } // namespace IncrementalResponse
} // namespace Sandglass

#endif
