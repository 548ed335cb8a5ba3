#ifndef sandglass_particle_stage_nodal_sums_h
#define sandglass_particle_stage_nodal_sums_h

#include <sandglass/material/stress.h>
#include <sandglass/particle_stage/cell_kernel.h>

namespace Sandglass
{
  /**
   * Steps 2 to 4 of Section 4.4, the sums over particles: lumped nodal mass
   * M_I, nodal momentum S^T M_d V (eq. 11) and nodal internal force R (eq. 9;
   * axisymmetric with the hoop row N_i / x of B). The gravity force of step 4
   * is the nodal mass times gravity and needs no sum of its own.
   */
  template <typename Setting>
  class NodalSums
  {
  public:
    static constexpr unsigned int n_nodes = Setting::nodes_per_cell;
    using Shape                           = CellShape<Setting::cell_type>;
    using SumsOfCell = CellValues<NodalSum::n_components, n_nodes>;

    static void
    compute(ParticleCloud                          &cloud,
            const CellGeometry<Setting::cell_type> &geometry,
            NodalField<NodalSum::n_components>     &sums)
    {
      sums.start_sum();
      for_each_filled_cell(cloud,
                           geometry,
                           [&sums](const unsigned int,
                                   const Shape &shape,
                                   const auto  &nodes,
                                   const auto  &particles) {
                             scatter(sums_of_cell(shape, particles),
                                     nodes,
                                     sums);
                           });
      sums.finish_sum();
    }

  private:
    template <typename ParticleRange>
    static SumsOfCell
    sums_of_cell(const Shape &shape, const ParticleRange &particles)
    {
      SumsOfCell       sums{};
      SymmetricTensor4 integrated_stress = SymmetricTensor4::Zero();
      for (const auto &particle : particles)
        {
          const double     *state     = particle.get_properties().data();
          const Point<dim> &reference = particle.get_reference_location();
          const auto        values    = Shape::shape_values(reference);
          add_mass_and_momentum(state, values, sums);

          const SymmetricTensor4 force_stress =
            state[Property::mass] / state[Property::density] *
            Eigen::Map<const SymmetricTensor4>(state + Property::stress);
          if constexpr (Setting::has_hoop_strain)
            for (unsigned int i = 0; i < n_nodes; ++i)
              sums[i][NodalSum::internal_force] += force_stress[Component::zz] *
                                                   values[i] /
                                                   particle.get_location()[0];
          if constexpr (Setting::has_constant_gradients)
            integrated_stress += force_stress;
          else
            add_internal_force(force_stress,
                               shape.shape_gradients(reference),
                               sums);
        }
      if constexpr (Setting::has_constant_gradients)
        add_internal_force(integrated_stress, shape.shape_gradients({}), sums);
      return sums;
    }

    static void
    add_mass_and_momentum(const double                      *state,
                          const std::array<double, n_nodes> &values,
                          SumsOfCell                        &sums)
    {
      for (unsigned int i = 0; i < n_nodes; ++i)
        {
          const double mass = state[Property::mass] * values[i];
          sums[i][NodalSum::mass] += mass;
          for (unsigned int d = 0; d < dim; ++d)
            sums[i][NodalSum::momentum + d] +=
              mass * state[Property::velocity + d];
        }
    }

    /// @param stress  times volume, in N m.
    static void
    add_internal_force(const SymmetricTensor4                    &stress,
                       const std::array<Tensor<1, dim>, n_nodes> &gradients,
                       SumsOfCell                                &sums)
    {
      for (unsigned int i = 0; i < n_nodes; ++i)
        {
          sums[i][NodalSum::internal_force] +=
            stress[Component::xx] * gradients[i][0] +
            stress[Component::xy] * gradients[i][1];
          sums[i][NodalSum::internal_force + 1] +=
            stress[Component::xy] * gradients[i][0] +
            stress[Component::yy] * gradients[i][1];
        }
    }
  };
} // namespace Sandglass

#endif
