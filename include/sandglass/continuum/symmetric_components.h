#ifndef sandglass_continuum_symmetric_components_h
#define sandglass_continuum_symmetric_components_h

#include <sandglass/base/lanes.h>

#include <Eigen/Core>

#include <cmath>

namespace Sandglass
{
  /**
   * Components of a symmetric tensor, in ParaView's order: (xx, yy, zz, xy, yz,
   * xz), of which plane strain and axisymmetry leave the first four; zz is then
   * the out-of-plane or hoop component. Stresses are in Pa, tension positive.
   * Shear components are the tensor's, not engineering strains.
   *
   * All functions here take any number n of components of at least four.
   *
   * @tparam Number  double for one tensor, Lanes for those of several
   * particles.
   */
  template <int n, typename Number = double>
  using SymmetricComponents = Eigen::Matrix<Number, n, 1>;

  /// Derivative of one symmetric tensor with respect to another.
  template <int n>
  using ComponentMatrix = Eigen::Matrix<double, n, n>;

  namespace Component
  {
    enum : int
    {
      xx = 0,
      yy = 1,
      zz = 2,
      xy = 3,
      yz = 4,
      xz = 5
    };

    /// From here on components are shear components.
    constexpr int first_shear = xy;
  } // namespace Component

  /// A vector type's number of components, known to the compiler.
  template <typename Derived>
  constexpr int n_components_of = Eigen::MatrixBase<Derived>::RowsAtCompileTime;

  /// What is added to a quantity's components where it is isotropic.
  template <int n, typename Number>
  SymmetricComponents<n, Number>
  isotropic(const Number &value)
  {
    SymmetricComponents<n, Number> result;
    for (int c = 0; c < n; ++c)
      result[c] = c < Component::first_shear ? value : Number(0.);
    return result;
  }

  template <typename Derived>
  typename Derived::Scalar
  trace(const Eigen::MatrixBase<Derived> &tensor)
  {
    return tensor[Component::xx] + tensor[Component::yy] +
           tensor[Component::zz];
  }

  /// p = -tr(stress) / 3, compression positive (paper, Section 2.2).
  template <typename Derived>
  typename Derived::Scalar
  pressure(const Eigen::MatrixBase<Derived> &stress)
  {
    using Number = typename Derived::Scalar;
    return -trace(stress) * Number(1. / 3.);
  }

  template <typename Derived>
  SymmetricComponents<n_components_of<Derived>, typename Derived::Scalar>
  deviator(const Eigen::MatrixBase<Derived> &stress)
  {
    return stress + isotropic<n_components_of<Derived>>(pressure(stress));
  }

  /// a : b; shear components count twice.
  template <int n, typename Number>
  Number
  double_contraction(const Eigen::Matrix<Number, n, 1> &a,
                     const Eigen::Matrix<Number, n, 1> &b)
  {
    Number sum = a.dot(b);
    for (int c = Component::first_shear; c < n; ++c)
      sum += a[c] * b[c];
    return sum;
  }

  /// q^2 = 3/2 s : s of the deviator s.
  template <typename Derived>
  typename Derived::Scalar
  squared_von_mises_stress(const Eigen::MatrixBase<Derived> &stress)
  {
    using Number = typename Derived::Scalar;
    const auto s = deviator(stress);
    return Number(1.5) * double_contraction(s, s);
  }

  /// q = sqrt(3/2 s : s) (paper, Section 2.2).
  template <typename Derived>
  typename Derived::Scalar
  von_mises_stress(const Eigen::MatrixBase<Derived> &stress)
  {
    using std::sqrt;
    return sqrt(squared_von_mises_stress(stress));
  }
} // namespace Sandglass

#endif
