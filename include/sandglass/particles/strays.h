#ifndef sandglass_particles_strays_h
#define sandglass_particles_strays_h

#include <sandglass/particles/particle_blocks.h>

#include <vector>

namespace Sandglass
{
  /**
   * Particles that have left their cells in a step, on their way to others.
   *
   * They are taken out cell by cell, while their blocks are still in the cache:
   * on fine meshes that is most of what a change of cell costs.
   */
  template <typename Layout>
  class Strays
  {
  public:
    /// Forget all, but keep the memory.
    void
    clear()
    {
      slots.clear();
      parcels.clear();
    }

    /// Add a particle. Those of a cell have to come in the order that
    /// ParticleBlocks::remove() asks for.
    void
    add(const ParticleSlot &slot)
    {
      slots.push_back(slot);
    }

    /// Take the particles added since the last call out of their cell.
    void
    take_out(ParticleBlocks<Layout> &blocks)
    {
      if (!slots.empty())
        take_out_all(blocks);
    }

    /// The particles taken out. Their reference coordinates are those in the
    /// cell that they have left, so they are not valid in any cell.
    std::vector<Parcel<Layout>> parcels;

  private:
    /// By itself, since the loop over cells is shorter without it.
    __attribute__((noinline)) void
    take_out_all(ParticleBlocks<Layout> &blocks)
    {
      for (const ParticleSlot &slot : slots)
        {
          parcels.push_back(blocks.parcel(slot));
          blocks.remove(slot);
        }
      slots.clear();
    }

    std::vector<ParticleSlot> slots;
  };
} // namespace Sandglass

#endif
