#ifndef sandglass_study_extrapolation_h
#define sandglass_study_extrapolation_h

#include <limits>
#include <vector>

namespace Sandglass
{
  /// A value on cells of size zero; NaN where it can't be told.
  struct Extrapolation
  {
    double value = std::numeric_limits<double>::quiet_NaN();
    /// Change of the value with the cells' size, per m.
    double slope = std::numeric_limits<double>::quiet_NaN();
    /// Half the width of an interval in which the value lies with a
    /// probability of about 95 %.
    double uncertainty = std::numeric_limits<double>::quiet_NaN();
  };

  /**
   * Fit value = q + a h to values q_i on cells of sizes h_i by least squares
   * with weights 1 / h_i^2, and take q: in a plane the number of particles that
   * a rate is the mean of goes with 1 / h^2, and its scatter so with h.
   *
   * The error at an outlet's lip is of first order (doc/graded-meshes.md), and
   * values scatter too much for an order to be fitted along with q: hence the
   * order is fixed. The uncertainty is the root of the sum of two squares, the
   * half 95 % interval of q by the scatter about the line (Student's t with
   * n - 2 degrees of freedom), and the difference from what an error of second
   * order, value = q + a h^2, would give.
   *
   * @param sizes   at least three, not all equal; in m.
   * @param values  as many.
   */
  Extrapolation
  extrapolate(const std::vector<double> &sizes,
              const std::vector<double> &values);
} // namespace Sandglass

#endif
