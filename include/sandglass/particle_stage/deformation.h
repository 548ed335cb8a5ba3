#ifndef sandglass_particle_stage_deformation_h
#define sandglass_particle_stage_deformation_h

#include <sandglass/material/stress.h>
#include <sandglass/particle_stage/cell_kernel.h>

namespace Sandglass
{
  /// Strain and rotation of one step, from the velocity v^L.
  struct DeformationIncrement
  {
    SymmetricTensor4 strain; ///< tensor components
    double           spin;   ///< omega_xy, in rad
    double           jacobian;

    /**
     * @param gradient  of the displacement increment, du_i/dx_j
     * @param hoop      u_x / x, zero in plane strain
     */
    DeformationIncrement(const Tensor<2, dim> &gradient, const double hoop)
      : strain(gradient[0][0],
               gradient[1][1],
               hoop,
               0.5 * (gradient[0][1] + gradient[1][0]))
      , spin(0.5 * (gradient[1][0] - gradient[0][1]))
      , jacobian(((1. + gradient[0][0]) * (1. + gradient[1][1]) -
                  gradient[0][1] * gradient[1][0]) *
                 (1. + hoop))
    {}

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
