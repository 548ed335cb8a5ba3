#ifndef sandglass_tests_divergence_h
#define sandglass_tests_divergence_h

#include <deal.II/base/point.h>

#include <sandglass/continuum/formulation.h>
#include <sandglass/continuum/symmetric_components.h>

/**
 * Divergence of a symmetric tensor field `field(point)` by central differences,
 * whose error in the fields of manufactured solutions is 1e-7 of the value.
 */
template <typename Field>
dealii::Tensor<1, 2>
divergence_of(const Field                 &field,
              const dealii::Point<2>      &point,
              const Sandglass::Formulation formulation)
{
  using Tensor4               = Sandglass::SymmetricComponents<4>;
  namespace C                 = Sandglass::Component;
  constexpr double distance   = 1e-4;
  const auto       derivative = [&](const unsigned int direction) {
    dealii::Point<2> before = point, after = point;
    before[direction] -= distance;
    after[direction] += distance;
    return Tensor4((field(after) - field(before)) / (2. * distance));
  };
  const Tensor4        along_x = derivative(0), along_y = derivative(1);
  dealii::Tensor<1, 2> divergence(
    {along_x[C::xx] + along_y[C::xy], along_x[C::xy] + along_y[C::yy]});
  if (formulation == Sandglass::Formulation::axisymmetric)
    {
      const Tensor4 here = field(point);
      divergence[0] += (here[C::xx] - here[C::zz]) / point[0];
      divergence[1] += here[C::xy] / point[0];
    }
  return divergence;
}

#endif
