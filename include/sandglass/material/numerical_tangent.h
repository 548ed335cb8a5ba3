#ifndef sandglass_material_numerical_tangent_h
#define sandglass_material_numerical_tangent_h

#include <sandglass/continuum/material_tangent.h>
#include <sandglass/material/elasticity.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  /**
   * Derivatives of a law's correct() by central differences, of an increment
   * without a time step (the state at rest has none).
   *
   * @param stress,state  at the increment's start, turned, in Pa.
   * @param stress_step  in Pa, positive: by how much stresses differ; strains
   * differ by as much as the law's stiffness bound answers with it. It has to
   * be far above what an adaptive integration adds to the result, and far below
   * what bends the law.
   */
  template <typename Law, int n, typename State, typename Increment>
  MaterialTangent<n>
  numerical_tangent(const Law                         &law,
                    const Eigen::Matrix<double, n, 1> &stress,
                    const State                       &state,
                    const Increment                   &increment,
                    const double                       stress_step)
  {
    const auto corrected = [&](const Eigen::Matrix<double, n, 1> &start,
                               const Increment                   &step) {
      Eigen::Matrix<double, n, 1> result    = start;
      State                       new_state = state;
      law.correct(result, new_state, law.predict(step, 0.));
      return result;
    };
    const double strain_step =
      stress_step / law.stiffness_bound(stress, state).confined_modulus();

    MaterialTangent<n> tangent;
    for (int c = 0; c < n; ++c)
      {
        Increment more = increment, less = increment;
        more.strain[c] += strain_step;
        less.strain[c] -= strain_step;
        tangent.by_strain.col(c) =
          (corrected(stress, more) - corrected(stress, less)) /
          (2. * strain_step);
        Eigen::Matrix<double, n, 1> higher = stress, lower = stress;
        higher[c] += stress_step;
        lower[c] -= stress_step;
        tangent.by_stress.col(c) =
          (corrected(higher, increment) - corrected(lower, increment)) /
          (2. * stress_step);
      }
    return tangent;
  }

  /// The same with differences of a ten-thousandth of the stress or of what the
  /// increment makes of it.
  template <typename Law, int n, typename State, typename Increment>
  MaterialTangent<n>
  numerical_tangent(const Law                         &law,
                    const Eigen::Matrix<double, n, 1> &stress,
                    const State                       &state,
                    const Increment                   &increment)
  {
    constexpr double relative = 1e-4, smallest_strain = 1e-7;
    const double     modulus =
      law.stiffness_bound(stress, state).confined_modulus();
    const double step =
      std::max(smallest_strain * modulus,
               relative *
                 std::max(stress.cwiseAbs().maxCoeff(),
                          modulus * increment.strain.cwiseAbs().maxCoeff()));
    return numerical_tangent(law, stress, state, increment, step);
  }
  /// A tangent with a share of an elasticity's, as Newton's method wants it
  /// where the derivative is zero or doesn't exist.
  template <int n>
  MaterialTangent<n>
  with_elastic_share(const MaterialTangent<n> &tangent,
                     const Elasticity         &elasticity,
                     const double              share)
  {
    return {(1. - share) * tangent.by_stress +
              share * ComponentMatrix<n>::Identity(),
            (1. - share) * tangent.by_strain +
              share * elasticity.template stiffness<n>()};
  }
} // namespace Sandglass

#endif
