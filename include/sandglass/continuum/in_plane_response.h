#ifndef sandglass_continuum_in_plane_response_h
#define sandglass_continuum_in_plane_response_h

#include <sandglass/continuum/in_plane_increment.h>
#include <sandglass/continuum/material_tangent.h>

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
  struct InPlaneResponse
  {
    using Gradient = Gradient5;
    using Tangent  = Matrix5;

    /// The in-plane part of F's cofactor, det(F) F^-T without the hoop factor;
    /// it is linear in F.
    static Eigen::Matrix2d
    in_plane_cofactor(const Gradient5 &H)
    {
      namespace G = GradientComponent;
      Eigen::Matrix2d cofactor;
      cofactor << 1. + H[G::yy], -H[G::yx], -H[G::xy], 1. + H[G::xx];
      return cofactor;
    }

    /// J, current volume over volume at the start of the step.
    static double
    volume_ratio(const Gradient5 &H)
    {
      return in_plane_cofactor(H).determinant() *
             (1. + H[GradientComponent::hoop]);
    }

    /// Strain sym(H) and rotation by the spin skew(H), by the forward-Euler
    /// rule of Section 4.1 of the paper; or both in the middle of the step,
    /// where motion takes steps of large strain.
    static InPlaneIncrement<double>
    increment(
      const Gradient5        &H,
      const StressIntegration integration = StressIntegration::start_of_step)
    {
      namespace G                 = GradientComponent;
      const double gradient[2][2] = {{H[G::xx], H[G::xy]},
                                     {H[G::yx], H[G::yy]}};
      return {gradient, H[G::hoop], integration};
    }

    /**
     * First Piola-Kirchhoff stress J sigma F^-T in Pa: what the virtual
     * displacement's gradient in the reference configuration works on.
     */
    static Gradient5
    piola_stress(const SymmetricComponents<4> &stress, const Gradient5 &H)
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
     * with respect to H.
     *
     * @param stress_before,stress  at the start and at the end of the step.
     * @param material  the law's part of it.
     */
    static Matrix5
    tangent(
      const SymmetricComponents<4> &stress_before,
      const SymmetricComponents<4> &stress,
      const Gradient5              &H,
      const MaterialTangent<4>     &material,
      const StressIntegration integration = StressIntegration::start_of_step);
  };
} // namespace Sandglass

#endif
