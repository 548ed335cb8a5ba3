#ifndef sandglass_tests_element_driver_h
#define sandglass_tests_element_driver_h

#include <sandglass/continuum/symmetric_components.h>

#include <array>
#include <cmath>

/**
 * A laboratory test of one element of a law with a void ratio: axial strain is
 * prescribed, and the lateral strain or the lateral stress. Compression is
 * positive here; y is the axis.
 */
template <typename Law>
class ElementDriver
{
public:
  /// Stresses in Pa.
  ElementDriver(const Law   &law,
                const double axial_stress,
                const double lateral_stress,
                const double void_ratio)
    : law(law)
    , stress(-lateral_stress, -axial_stress, -lateral_stress, 0.)
    , state{{void_ratio}}
  {}

  /// Laterally confined.
  void
  compress_confined(const double axial_strain)
  {
    strain(axial_strain, 0.);
  }

  /// With the lateral stress kept: its strain by the secant method.
  void
  compress_triaxial(const double axial_strain)
  {
    const double target = stress[0];
    const auto   before = std::make_pair(stress, state);
    const auto   excess = [&](const double lateral_strain) {
      stress = before.first;
      state  = before.second;
      strain(axial_strain, lateral_strain);
      return stress[0] - target;
    };
    double last = -0.5 * axial_strain, last_excess = excess(last);
    double next = last_lateral_ratio * axial_strain;
    if (next == last)
      next *= 1.01;
    for (unsigned int i = 0; i < 30; ++i)
      {
        const double next_excess = excess(next);
        if (std::abs(next_excess) < 1e-8 * std::abs(target) ||
            next_excess == last_excess)
          break;
        const double better =
          next - next_excess * (next - last) / (next_excess - last_excess);
        last        = next;
        last_excess = next_excess;
        next        = better;
      }
    last_lateral_ratio = next / axial_strain;
  }

  double
  axial_stress() const
  {
    return -stress[1];
  }

  double
  lateral_stress() const
  {
    return -stress[0];
  }

  /// q = sigma_1 - sigma_3 in Pa.
  double
  deviatoric_stress() const
  {
    return axial_stress() - lateral_stress();
  }

  double
  void_ratio() const
  {
    return state[0];
  }

  /// Of the last triaxial step.
  double
  lateral_ratio() const
  {
    return last_lateral_ratio;
  }

private:
  void
  strain(const double axial, const double lateral)
  {
    const Sandglass::SymmetricComponents<4> increment(-lateral,
                                                      -axial,
                                                      -lateral,
                                                      0.);
    law.correct(stress, state, increment);
  }

  const Law                         law;
  Sandglass::SymmetricComponents<4> stress;
  std::array<double, 1>             state;
  double                            last_lateral_ratio = -0.2;
};

#endif
