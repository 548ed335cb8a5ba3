#ifndef sandglass_continuum_solid_response_h
#define sandglass_continuum_solid_response_h

#include <sandglass/continuum/material_tangent.h>
#include <sandglass/continuum/solid_increment.h>

#include <Eigen/LU>

namespace Sandglass
{
  /// A gradient that isn't symmetric, du_i/dx_j at 3 i + j.
  using Gradient9 = Eigen::Matrix<double, 9, 1>;
  using Matrix9   = Eigen::Matrix<double, 9, 9>;

  /**
   * What a load step of the updated Lagrangian formulation does to a material
   * point in space. The configuration at the start of the step is the
   * reference: H is the gradient of the displacement increment with respect to
   * it, F = I + H the increment's deformation gradient, J = det(F).
   */
  struct SolidResponse
  {
    using Gradient = Gradient9;
    using Tangent  = Matrix9;

    /// F's cofactor, J F^-T.
    static Eigen::Matrix3d
    cofactor(const Gradient9 &H);

    /// J, current volume over volume at the start of the step.
    static double
    volume_ratio(const Gradient9 &H);

    /// Strain sym(H) and rotation by the spin skew(H), by the forward-Euler
    /// rule of Section 4.1 of the paper; or both in the middle of the step,
    /// where motion takes steps of large strain.
    static SolidIncrement<double>
    increment(
      const Gradient9        &H,
      const StressIntegration integration = StressIntegration::start_of_step);

    /**
     * First Piola-Kirchhoff stress J sigma F^-T in Pa: what the virtual
     * displacement's gradient in the reference configuration works on.
     */
    static Gradient9
    piola_stress(const SymmetricComponents<6> &stress, const Gradient9 &H);

    /**
     * Consistent tangent: the derivative of the first Piola-Kirchhoff stress
     * with respect to H.
     *
     * @param stress_before,stress  at the start and at the end of the step.
     * @param material  the law's part of it.
     */
    static Matrix9
    tangent(
      const SymmetricComponents<6> &stress_before,
      const SymmetricComponents<6> &stress,
      const Gradient9              &H,
      const MaterialTangent<6>     &material,
      const StressIntegration integration = StressIntegration::start_of_step);
  };
} // namespace Sandglass

#endif
