#ifndef sandglass_continuum_solid_increment_h
#define sandglass_continuum_solid_increment_h

#include <sandglass/continuum/solid_rotation.h>
#include <sandglass/continuum/stress_integration.h>

#include <array>

namespace Sandglass
{
  /// Strain and rotation of one step in space, from the velocity v^L.
  template <typename Number>
  struct SolidIncrement
  {
    using Gradient = std::array<std::array<Number, 3>, 3>;

    SymmetricComponents<6, Number> strain; ///< tensor components
    SolidRotation<Number>          rotation;
    Number                         jacobian;
    /// du_i/dx_j, x at the start; for who follows the deformation gradient.
    Gradient gradient;

    /**
     * @param gradient  of the displacement increment, du_i/dx_j as [i][j], x at
     *                  the start
     * @param           the hoop strain, which space doesn't have
     */
    SolidIncrement(
      const Gradient &gradient,
      const Number & /*hoop*/,
      const StressIntegration integration = StressIntegration::start_of_step)
      : jacobian(determinant(sum_with_identity(gradient, 1.)))
      , gradient(gradient)
    {
      if (integration == StressIntegration::start_of_step)
        {
          set_strain(gradient);
          rotation = SolidRotation<Number>::forward_euler(spin(gradient));
          return;
        }
      const Gradient middle_gradient = in_the_middle(gradient);
      const auto     middle_spin     = spin(middle_gradient);
      set_strain(middle_gradient);
      rotation = SolidRotation<Number>::hughes_winget(middle_spin);
      strain =
        rotate(strain, SolidRotation<Number>::half_hughes_winget(middle_spin));
    }

    /// tr(strain)
    Number
    volume_change() const
    {
      return trace(strain);
    }

    /// Change volume_change() by a difference.
    void
    add_volume_change(const Number &difference)
    {
      strain += isotropic<6>(Number(1. / 3.) * difference);
      jacobian *= Number(1.) + difference;
    }

  private:
    /// 1 + factor * gradient
    static Gradient
    sum_with_identity(const Gradient &gradient, const double factor)
    {
      Gradient sum;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          sum[i][j] =
            Number(factor) * gradient[i][j] + Number(i == j ? 1. : 0.);
      return sum;
    }

    /// Cofactor of an entry, by which the inverse's transpose is made.
    static Number
    cofactor(const Gradient &a, const unsigned int i, const unsigned int j)
    {
      const unsigned int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
      const unsigned int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      return a[i1][j1] * a[i2][j2] - a[i1][j2] * a[i2][j1];
    }

    static Number
    determinant(const Gradient &a)
    {
      return a[0][0] * cofactor(a, 0, 0) + a[0][1] * cofactor(a, 0, 1) +
             a[0][2] * cofactor(a, 0, 2);
    }

    /// The gradient with respect to the positions in the middle of the step:
    /// `gradient` times the inverse of dx_middle / dx = 1 + gradient / 2.
    static Gradient
    in_the_middle(const Gradient &gradient)
    {
      const Gradient to_middle = sum_with_identity(gradient, 0.5);
      const Number   scale     = Number(1.) / determinant(to_middle);
      Gradient       inverse;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          inverse[i][j] = scale * cofactor(to_middle, j, i);
      Gradient result;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          result[i][j] = gradient[i][0] * inverse[0][j] +
                         gradient[i][1] * inverse[1][j] +
                         gradient[i][2] * inverse[2][j];
      return result;
    }

    void
    set_strain(const Gradient &gradient)
    {
      const Number half(0.5);
      strain[Component::xx] = gradient[0][0];
      strain[Component::yy] = gradient[1][1];
      strain[Component::zz] = gradient[2][2];
      strain[Component::xy] = half * (gradient[0][1] + gradient[1][0]);
      strain[Component::yz] = half * (gradient[1][2] + gradient[2][1]);
      strain[Component::xz] = half * (gradient[0][2] + gradient[2][0]);
    }

    /// Half the curl, in rad.
    static std::array<Number, 3>
    spin(const Gradient &gradient)
    {
      const Number half(0.5);
      return {{half * (gradient[2][1] - gradient[1][2]),
               half * (gradient[0][2] - gradient[2][0]),
               half * (gradient[1][0] - gradient[0][1])}};
    }
  };
} // namespace Sandglass

#endif
