#ifndef sandglass_tests_return_case_h
#define sandglass_tests_return_case_h

#include <sandglass/continuum/symmetric_components.h>

/// The three cases in which stress returns to the yield surface (paper, Section
/// 4.1).
enum class ReturnCase
{
  elastic,   ///< the trial stress is admissible
  yielding,  ///< its deviator shrinks
  separated, ///< no stress is left
};

/// The case that a law's answer to a trial stress shows.
template <int n>
ReturnCase
case_of(const Eigen::Matrix<double, n, 1> &trial_stress,
        const Eigen::Matrix<double, n, 1> &stress)
{
  if (stress == trial_stress)
    return ReturnCase::elastic;
  return stress.isZero(0.) ? ReturnCase::separated : ReturnCase::yielding;
}

#endif
