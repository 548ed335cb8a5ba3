#ifndef sandglass_continuum_in_plane_increment_h
#define sandglass_continuum_in_plane_increment_h

#include <sandglass/continuum/in_plane_rotation.h>
#include <sandglass/continuum/stress_integration.h>

#include <array>

namespace Sandglass
{
  /// Strain and rotation of one step, from the velocity v^L.
  template <typename Number>
  struct InPlaneIncrement
  {
    SymmetricComponents<4, Number> strain; ///< tensor components
    InPlaneRotation<Number>        rotation;
    Number                         jacobian;
    /// du_i/dx_j, x at the start; for who follows the deformation gradient.
    std::array<std::array<Number, 2>, 2> gradient;

    /**
     * @param gradient  of the displacement increment, du_i/dx_j as [i][j], x at
     *                  the start
     * @param hoop      u_x / x, zero in plane strain
     */
    template <typename Gradient>
    InPlaneIncrement(
      const Gradient         &gradient,
      const Number           &hoop,
      const StressIntegration integration = StressIntegration::start_of_step)
      : jacobian(determinant_of_sum(gradient, 1.) * (Number(1.) + hoop))
      , gradient{{{{gradient[0][0], gradient[0][1]}},
                  {{gradient[1][0], gradient[1][1]}}}}
    {
      if (integration == StressIntegration::start_of_step)
        {
          set_strain(gradient, hoop);
          rotation = InPlaneRotation<Number>::forward_euler(spin(gradient));
          return;
        }
      const auto   middle_gradient = in_the_middle(gradient);
      const Number middle_spin     = spin(middle_gradient);
      set_strain(middle_gradient, hoop / (Number(1.) + Number(0.5) * hoop));
      rotation = InPlaneRotation<Number>::hughes_winget(middle_spin);
      strain   = rotate(strain,
                      InPlaneRotation<Number>::half_hughes_winget(middle_spin));
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
      strain += isotropic<4>(Number(1. / 3.) * difference);
      jacobian *= Number(1.) + difference;
    }

  private:
    /// det(1 + factor * gradient)
    template <typename Gradient>
    static Number
    determinant_of_sum(const Gradient &gradient, const double factor)
    {
      const Number f(factor), one(1.);
      return (one + f * gradient[0][0]) * (one + f * gradient[1][1]) -
             f * gradient[0][1] * (f * gradient[1][0]);
    }

    /// The gradient with respect to the positions in the middle of the step:
    /// `gradient` times the inverse of dx_middle / dx = 1 + gradient / 2.
    template <typename Gradient>
    static std::array<std::array<Number, 2>, 2>
    in_the_middle(const Gradient &gradient)
    {
      const Number half(0.5), one(1.);
      const Number scale         = one / determinant_of_sum(gradient, 0.5);
      const Number inverse[2][2] = {{(one + half * gradient[1][1]) * scale,
                                     -half * gradient[0][1] * scale},
                                    {-half * gradient[1][0] * scale,
                                     (one + half * gradient[0][0]) * scale}};
      std::array<std::array<Number, 2>, 2> result;
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < 2; ++j)
          result[i][j] =
            gradient[i][0] * inverse[0][j] + gradient[i][1] * inverse[1][j];
      return result;
    }

    template <typename Gradient>
    void
    set_strain(const Gradient &gradient, const Number &hoop)
    {
      strain = {gradient[0][0],
                gradient[1][1],
                hoop,
                Number(0.5) * (gradient[0][1] + gradient[1][0])};
    }

    /// omega_xy, in rad, positive counterclockwise
    template <typename Gradient>
    static Number
    spin(const Gradient &gradient)
    {
      return Number(0.5) * (gradient[1][0] - gradient[0][1]);
    }
  };
} // namespace Sandglass

#endif
