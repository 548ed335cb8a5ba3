#ifndef sandglass_particles_particle_state_h
#define sandglass_particles_particle_state_h

#include <sandglass/continuum/symmetric_components.h>
#include <sandglass/particles/particle_blocks.h>

namespace Sandglass
{
  /// State of one particle (Number is double) or of a block's (Lanes).
  template <typename Layout_, typename Number>
  struct ParticleState
  {
    using Layout = Layout_;

    static constexpr int dim = Layout::dim;

    std::array<Number, dim> location;                          ///< in m
    std::array<Number, dim> reference;                         ///< in the cell
    Number                  mass;                              ///< in kg
    std::array<Number, dim> velocity;                          ///< in m/s
    SymmetricComponents<Layout::n_components, Number> stress;  ///< in Pa
    Number                                            density; ///< in kg/m^3
    std::array<Number, Layout::n_law_numbers>         law_state;

    /// In m^3, in plane strain per metre of depth.
    Number
    volume() const
    {
      return mass / density;
    }
  };

  /// Call `function(number, quantity)` for all that a state holds but the mass,
  /// with the ParticleBlock::Quantity at which it is stored.
  template <typename State, typename Function>
  void
  for_each_changing_number(State &state, const Function &function)
  {
    using Layout = typename State::Layout;
    using Block  = ParticleBlock<Layout>;
    for (unsigned int d = 0; d < Layout::dim; ++d)
      {
        function(state.location[d], Block::location + d);
        function(state.reference[d], Block::reference + d);
        function(state.velocity[d], Block::velocity + d);
      }
    for (unsigned int c = 0; c < Layout::n_components; ++c)
      function(state.stress[c], Block::stress + c);
    function(state.density, Block::density);
    for (unsigned int i = 0; i < Layout::n_law_numbers; ++i)
      function(state.law_state[i], Block::law_state + i);
  }

  template <typename Layout>
  ParticleState<Layout, Lanes>
  load_state(const ParticleBlock<Layout> &block)
  {
    ParticleState<Layout, Lanes> state;
    for_each_changing_number(state,
                             [&block](Lanes &number, const unsigned int q) {
                               number = block.load(q);
                             });
    state.mass = block.load(ParticleBlock<Layout>::mass);
    return state;
  }

  template <typename Layout>
  ParticleState<Layout, double>
  load_state(const ParticleBlock<Layout> &block, const unsigned int lane)
  {
    ParticleState<Layout, double> state;
    for_each_changing_number(state,
                             [&block, lane](double            &number,
                                            const unsigned int q) {
                               number = block.values[q][lane];
                             });
    state.mass = block.values[ParticleBlock<Layout>::mass][lane];
    return state;
  }

  /// Store all but the mass, which does not change in a pass.
  template <typename Layout>
  void
  store_state(const ParticleState<Layout, Lanes> &state,
              ParticleBlock<Layout>              &block)
  {
    for_each_changing_number(state,
                             [&block](const Lanes       &number,
                                      const unsigned int q) {
                               block.store(q, number);
                             });
  }
} // namespace Sandglass

#endif
