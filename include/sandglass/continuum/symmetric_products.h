#ifndef sandglass_continuum_symmetric_products_h
#define sandglass_continuum_symmetric_products_h

#include <sandglass/continuum/symmetric_components.h>

namespace Sandglass
{
  /// The symmetric part of the product of two symmetric tensors, (a b + b a)
  /// / 2.
  template <int n, typename Number>
  SymmetricComponents<n, Number>
  product(const Eigen::Matrix<Number, n, 1> &a,
          const Eigen::Matrix<Number, n, 1> &b)
  {
    static_assert(n == 4 || n == 6, "in a plane or in space");
    constexpr int xx = 0, yy = 1, zz = 2, xy = 3;
    const Number  half(0.5);

    SymmetricComponents<n, Number> result;
    const Number                   in_plane = a[xy] * b[xy];
    result[xx]                              = a[xx] * b[xx] + in_plane;
    result[yy]                              = a[yy] * b[yy] + in_plane;
    result[zz]                              = a[zz] * b[zz];
    result[xy] = half * ((a[xx] + a[yy]) * b[xy] + (b[xx] + b[yy]) * a[xy]);
    if constexpr (n == 6)
      {
        constexpr int yz = 4, xz = 5;
        const Number  over_y = a[yz] * b[yz], over_x = a[xz] * b[xz];
        result[xx] += over_x;
        result[yy] += over_y;
        result[zz] += over_x + over_y;
        result[xy] += half * (a[xz] * b[yz] + a[yz] * b[xz]);
        result[yz] = half * ((a[yy] + a[zz]) * b[yz] + (b[yy] + b[zz]) * a[yz] +
                             a[xy] * b[xz] + a[xz] * b[xy]);
        result[xz] = half * ((a[xx] + a[zz]) * b[xz] + (b[xx] + b[zz]) * a[xz] +
                             a[xy] * b[yz] + a[yz] * b[xy]);
      }
    return result;
  }

  template <int n, typename Number>
  SymmetricComponents<n, Number>
  squared(const Eigen::Matrix<Number, n, 1> &a)
  {
    return product(a, a);
  }

  template <int n, typename Number>
  Number
  determinant(const Eigen::Matrix<Number, n, 1> &a)
  {
    static_assert(n == 4 || n == 6, "in a plane or in space");
    Number result = a[2] * (a[0] * a[1] - a[3] * a[3]);
    if constexpr (n == 6)
      result += Number(2.) * a[3] * a[4] * a[5] - a[0] * a[4] * a[4] -
                a[1] * a[5] * a[5];
    return result;
  }
} // namespace Sandglass

#endif
