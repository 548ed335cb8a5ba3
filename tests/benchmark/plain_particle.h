#ifndef sandglass_tests_benchmark_plain_particle_h
#define sandglass_tests_benchmark_plain_particle_h

#include <sandglass/flow/particle_in_cell/nodal_fields.h>
#include <sandglass/particles/particle_state.h>

/// What the plain loop does for one particle of deal.II's ParticleHandler.
namespace PlainParticle
{
  using namespace Sandglass;

  template <typename Layout, typename Particle>
  ParticleState<Layout, double>
  state_of(const Particle &particle)
  {
    using Block            = ParticleBlock<Layout>;
    const auto &location   = particle.get_location();
    const auto &reference  = particle.get_reference_location();
    const auto  properties = particle.get_properties();

    ParticleState<Layout, double> state;
    for_each_changing_number(state,
                             [&](double &number, const unsigned int quantity) {
                               number =
                                 quantity < Block::reference ?
                                   location[quantity] :
                                 quantity < Block::properties ?
                                   reference[quantity - Block::reference] :
                                   properties[quantity - Block::properties];
                             });
    state.mass = properties[Layout::mass];
    return state;
  }

  /// Add the particle's mass, momentum and internal force at its cell's nodes.
  template <typename Setting, typename CellSums>
  void
  add_to_sums(const ParticleState<typename Setting::Layout, double> &state,
              const typename Setting::Shape                         &shape,
              CellSums                                              &sums)
  {
    constexpr int dim      = Setting::dim;
    using NodalSum         = Sandglass::NodalSum<dim>;
    const auto   values    = shape.shape_values(state.reference);
    const auto   gradients = shape.shape_gradients(state.reference);
    const double volume    = state.volume();
    const auto  &stress    = state.stress;
    for (unsigned int i = 0; i < Setting::nodes_per_cell; ++i)
      {
        const double mass = state.mass * values[i];
        sums[i][NodalSum::mass] += mass;
        for (unsigned int d = 0; d < dim; ++d)
          sums[i][NodalSum::momentum + d] += mass * state.velocity[d];

        double       *force    = &sums[i][NodalSum::internal_force];
        const double *gradient = gradients[i].data();
        force[0] += volume * (stress[Component::xx] * gradient[0] +
                              stress[Component::xy] * gradient[1]);
        force[1] += volume * (stress[Component::xy] * gradient[0] +
                              stress[Component::yy] * gradient[1]);
        if constexpr (dim == 3)
          {
            force[0] += volume * stress[Component::xz] * gradient[2];
            force[1] += volume * stress[Component::yz] * gradient[2];
            force[2] += volume * (stress[Component::xz] * gradient[0] +
                                  stress[Component::yz] * gradient[1] +
                                  stress[Component::zz] * gradient[2]);
          }
        if constexpr (Setting::has_hoop_strain)
          force[0] +=
            volume * stress[Component::zz] * values[i] / state.location[0];
      }
  }

  /// Store what steps 8 and 9 change.
  template <typename Layout, typename Particle>
  void
  store_moved_state(const ParticleState<Layout, double> &state,
                    Particle                            &particle)
  {
    const auto properties = particle.get_properties();
    std::copy_n(state.stress.data(),
                state.stress.size(),
                properties.begin() + Layout::stress);
    properties[Layout::density] = state.density;
    particle.set_location(point_of(state.location));
    particle.set_reference_location(point_of(state.reference));
  }
} // namespace PlainParticle

#endif
