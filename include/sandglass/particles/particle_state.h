#ifndef sandglass_particles_particle_state_h
#define sandglass_particles_particle_state_h

#include <sandglass/material/stress.h>
#include <sandglass/particles/cell_shape.h>
#include <sandglass/particles/particle_blocks.h>

namespace Sandglass
{
  /// State of one particle (Number is double) or of a block's (Lanes).
  template <typename Number>
  struct ParticleState
  {
    Pair<Number>              location;  ///< in m
    Pair<Number>              reference; ///< coordinates in the cell
    Number                    mass;      ///< in kg
    Pair<Number>              velocity;  ///< in m/s
    SymmetricTensorOf<Number> stress;    ///< in Pa
    Number                    density;   ///< in kg/m^3

    /// In m^3, in plane strain per metre of depth.
    Number
    volume() const
    {
      return mass / density;
    }
  };

  /// @param load  gives the number stored for a ParticleBlock::Quantity.
  template <typename Number, typename Load>
  ParticleState<Number>
  load_state(const Load &load)
  {
    constexpr unsigned int properties = ParticleBlock::properties;
    ParticleState<Number>  state;
    for (unsigned int d = 0; d < dim; ++d)
      {
        state.location[d]  = load(ParticleBlock::location + d);
        state.reference[d] = load(ParticleBlock::reference + d);
        state.velocity[d]  = load(properties + Property::velocity + d);
      }
    for (unsigned int c = 0; c < 4; ++c)
      state.stress[c] = load(properties + Property::stress + c);
    state.mass    = load(properties + Property::mass);
    state.density = load(properties + Property::density);
    return state;
  }

  inline ParticleState<Lanes>
  load_state(const ParticleBlock &block)
  {
    return load_state<Lanes>(
      [&block](const unsigned int quantity) { return block.load(quantity); });
  }

  inline ParticleState<double>
  load_state(const ParticleBlock &block, const unsigned int lane)
  {
    return load_state<double>([&block, lane](const unsigned int quantity) {
      return block.values[quantity][lane];
    });
  }

  /// All but the mass, which does not change in a pass.
  inline void
  store_state(const ParticleState<Lanes> &state, ParticleBlock &block)
  {
    constexpr unsigned int properties = ParticleBlock::properties;
    for (unsigned int d = 0; d < dim; ++d)
      {
        block.store(ParticleBlock::location + d, state.location[d]);
        block.store(ParticleBlock::reference + d, state.reference[d]);
        block.store(properties + Property::velocity + d, state.velocity[d]);
      }
    for (unsigned int c = 0; c < 4; ++c)
      block.store(properties + Property::stress + c, state.stress[c]);
    block.store(properties + Property::density, state.density);
  }
} // namespace Sandglass

#endif
