#ifndef sandglass_material_numerical_tangent_h
#define sandglass_material_numerical_tangent_h

#include <sandglass/continuum/material_tangent.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  /**
   * Derivatives of a law's correct() by central differences, of an increment
   * without a time step (the state at rest has none).
   *
   * @param stress,state  at the increment's start, turned, in Pa.
   */
  template <typename Law, int n, typename State, typename Increment>
  MaterialTangent<n>
  numerical_tangent(const Law                         &law,
                    const Eigen::Matrix<double, n, 1> &stress,
                    const State                       &state,
                    const Increment                   &increment)
  {
    const auto corrected = [&](const Eigen::Matrix<double, n, 1> &start,
                               const Increment                   &step) {
      Eigen::Matrix<double, n, 1> result    = start;
      State                       new_state = state;
      law.correct(result, new_state, law.predict(step, 0.));
      return result;
    };
    // A share of the strain that makes or undoes the stress; it rounds the
    // stress off less than it bends the law.
    const double modulus =
      law.stiffness_bound(stress, state).confined_modulus();
    const double strain_size =
      std::max(1e-7,
               1e-4 * std::max(stress.cwiseAbs().maxCoeff() / modulus,
                               increment.strain.cwiseAbs().maxCoeff()));
    const double stress_size = strain_size * modulus;

    MaterialTangent<n> tangent;
    for (int c = 0; c < n; ++c)
      {
        Increment more = increment, less = increment;
        more.strain[c] += strain_size;
        less.strain[c] -= strain_size;
        tangent.by_strain.col(c) =
          (corrected(stress, more) - corrected(stress, less)) /
          (2. * strain_size);
        Eigen::Matrix<double, n, 1> higher = stress, lower = stress;
        higher[c] += stress_size;
        lower[c] -= stress_size;
        tangent.by_stress.col(c) =
          (corrected(higher, increment) - corrected(lower, increment)) /
          (2. * stress_size);
      }
    return tangent;
  }
} // namespace Sandglass

#endif
