#ifndef sandglass_material_elasticity_h
#define sandglass_material_elasticity_h

#include <sandglass/continuum/symmetric_components.h>

#include <cmath>

namespace Sandglass
{
  /// Isotropic linear elasticity (paper, Section 2.2). Moduli in Pa.
  struct Elasticity
  {
    Elasticity(const double young_modulus, const double poisson_ratio)
      : lame_modulus(young_modulus * poisson_ratio /
                     ((1. + poisson_ratio) * (1. - 2. * poisson_ratio)))
      , shear_modulus(young_modulus / (2. * (1. + poisson_ratio)))
    {}

    double lame_modulus;
    double shear_modulus;

    double
    bulk_modulus() const
    {
      return lame_modulus + 2. / 3. * shear_modulus;
    }

    /// Modulus of uniaxial strain, lambda + 2 G, in Pa.
    double
    confined_modulus() const
    {
      return lame_modulus + 2. * shear_modulus;
    }

    /// Speed of dilatational waves in m/s.
    double
    wave_speed(const double density) const
    {
      return std::sqrt(confined_modulus() / density);
    }

    template <int n, typename Number>
    SymmetricComponents<n, Number>
    stress(const Eigen::Matrix<Number, n, 1> &strain) const
    {
      return Number(2. * shear_modulus) * strain +
             isotropic<n>(Number(lame_modulus) * trace(strain));
    }

    /// Derivative of stress() with respect to the strain.
    template <int n>
    ComponentMatrix<n>
    stiffness() const
    {
      const SymmetricComponents<n> one = isotropic<n>(1.);
      return 2. * shear_modulus * ComponentMatrix<n>::Identity() +
             lame_modulus * one * one.transpose();
    }

    /// Elastic energy per volume, in J/m^3, of a stress in Pa.
    template <typename Derived>
    typename Derived::Scalar
    energy_density(const Eigen::MatrixBase<Derived> &stress) const
    {
      using Number   = typename Derived::Scalar;
      const Number p = pressure(stress);
      const auto   s = deviator(stress);
      return p * p * Number(1. / (2. * bulk_modulus())) +
             double_contraction(s, s) * Number(1. / (4. * shear_modulus));
    }
  };
} // namespace Sandglass

#endif
