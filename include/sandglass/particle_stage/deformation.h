#ifndef sandglass_particle_stage_deformation_h
#define sandglass_particle_stage_deformation_h

#include <sandglass/material/stress.h>
#include <sandglass/particle_stage/cell_kernel.h>
#include <sandglass/particle_stage/particle_stage_parameters.h>

namespace Sandglass
{
  /// Strain and rotation of one step, from the velocity v^L.
  struct DeformationIncrement
  {
    SymmetricTensor4 strain; ///< tensor components
    StressRotation   rotation;
    double           jacobian;

    /**
     * @param gradient  of the displacement increment, du_i/dx_j, x at the start
     * @param hoop      u_x / x, zero in plane strain
     */
    DeformationIncrement(
      const Tensor<2, dim>   &gradient,
      const double            hoop,
      const StressIntegration integration = StressIntegration::start_of_step)
      : jacobian(((1. + gradient[0][0]) * (1. + gradient[1][1]) -
                  gradient[0][1] * gradient[1][0]) *
                 (1. + hoop))
    {
      if (integration == StressIntegration::start_of_step)
        {
          set_strain(gradient, hoop);
          rotation = StressRotation::forward_euler(spin(gradient));
          return;
        }
      Tensor<2, dim> middle = 0.5 * gradient; // dx_middle / dx
      for (unsigned int d = 0; d < dim; ++d)
        middle[d][d] += 1.;
      const Tensor<2, dim> middle_gradient = gradient * invert(middle);
      set_strain(middle_gradient, hoop / (1. + 0.5 * hoop));
      const double middle_spin = spin(middle_gradient);
      rotation                 = StressRotation::hughes_winget(middle_spin);
      strain = rotate(strain, StressRotation::half_hughes_winget(middle_spin));
    }

    /// The same with another change of volume, theta = tr(strain).
    DeformationIncrement
    with_volume_change(const double theta) const
    {
      const double difference = theta - strain[Component::xx] -
                                strain[Component::yy] - strain[Component::zz];
      DeformationIncrement result(*this);
      result.strain += difference / 3. * SymmetricTensor4(1., 1., 1., 0.);
      result.jacobian *= 1. + difference;
      return result;
    }

  private:
    void
    set_strain(const Tensor<2, dim> &gradient, const double hoop)
    {
      strain = {gradient[0][0],
                gradient[1][1],
                hoop,
                0.5 * (gradient[0][1] + gradient[1][0])};
    }

    /// omega_xy, in rad, positive counterclockwise
    static double
    spin(const Tensor<2, dim> &gradient)
    {
      return 0.5 * (gradient[1][0] - gradient[0][1]);
    }
  };

  /// sum_i N_i v_i
  template <std::size_t n_nodes>
  Tensor<1, dim>
  interpolate(const CellValues<dim, n_nodes>    &nodal_values,
              const std::array<double, n_nodes> &shape_values)
  {
    Tensor<1, dim> value;
    for (unsigned int i = 0; i < n_nodes; ++i)
      for (unsigned int d = 0; d < dim; ++d)
        value[d] += shape_values[i] * nodal_values[i][d];
    return value;
  }

  /// sum_i v_i dN_i/dx
  template <std::size_t n_nodes>
  Tensor<2, dim>
  gradient_of(const CellValues<dim, n_nodes>            &nodal_values,
              const std::array<Tensor<1, dim>, n_nodes> &shape_gradients)
  {
    Tensor<2, dim> gradient;
    for (unsigned int i = 0; i < n_nodes; ++i)
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int e = 0; e < dim; ++e)
          gradient[d][e] += nodal_values[i][d] * shape_gradients[i][e];
    return gradient;
  }
} // namespace Sandglass

#endif
