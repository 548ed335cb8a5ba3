#ifndef sandglass_continuum_midpoint_stress_derivative_h
#define sandglass_continuum_midpoint_stress_derivative_h

#include <sandglass/continuum/in_plane_rotation.h>
#include <sandglass/continuum/material_tangent.h>
#include <sandglass/continuum/solid_rotation.h>
#include <sandglass/continuum/stress_integration.h>

#include <Eigen/Core>

namespace Sandglass
{
  /**
   * How the stress after a step changes with the displacement gradient H where
   * strain and rotation are taken in the middle of the step: their derivatives
   * by central differences, which cost less than the law and are exact to ten
   * digits.
   *
   * @tparam Response  InPlaneResponse or SolidResponse.
   */
  template <typename Response, int n_stress, int n_gradient>
  Eigen::Matrix<double, n_stress, n_gradient>
  midpoint_stress_derivative(const SymmetricComponents<n_stress> &stress_before,
                             const Eigen::Matrix<double, n_gradient, 1> &H,
                             const MaterialTangent<n_stress> &material)
  {
    constexpr double                            step = 1e-5;
    Eigen::Matrix<double, n_stress, n_gradient> derivative;
    for (int c = 0; c < n_gradient; ++c)
      {
        Eigen::Matrix<double, n_gradient, 1> more = H, less = H;
        more[c] += step;
        less[c] -= step;
        const auto after =
          Response::increment(more, StressIntegration::middle_of_step);
        const auto before =
          Response::increment(less, StressIntegration::middle_of_step);
        const SymmetricComponents<n_stress> strain =
          after.strain - before.strain;
        const SymmetricComponents<n_stress> turned =
          rotate(stress_before, after.rotation) -
          rotate(stress_before, before.rotation);
        derivative.col(c) =
          (material.by_strain * strain + material.by_stress * turned) /
          (2. * step);
      }
    return derivative;
  }
} // namespace Sandglass

#endif
