#ifndef sandglass_particles_particle_blocks_templates_h
#define sandglass_particles_particle_blocks_templates_h

#include <sandglass/particles/particle_blocks.h>

#include <algorithm>

namespace Sandglass
{
  template <typename Layout>
  void
  ParticleBlocks<Layout>::clear()
  {
    blocks.clear();
    links.clear();
    unused.clear();
    std::fill(first.begin(), first.end(), none);
    n_stored = 0;
  }



  template <typename Layout>
  ParticleSlot
  ParticleBlocks<Layout>::insert(const Parcel &parcel)
  {
    unsigned int block = first[parcel.cell];
    if (block == none || links[block].n_lanes == Lanes::n)
      block = add_block(parcel.cell);
    const ParticleSlot slot{parcel.cell, block, links[block].n_lanes++};
    overwrite(slot, parcel);
    ++n_stored;
    return slot;
  }



  template <typename Layout>
  void
  ParticleBlocks<Layout>::remove(const ParticleSlot &slot)
  {
    const unsigned int head = first[slot.cell];
    const unsigned int last = --links[head].n_lanes;
    for (unsigned int q = 0; q < Block::n_quantities; ++q)
      blocks[slot.block].values[q][slot.lane] = blocks[head].values[q][last];
    links[slot.block].ids[slot.lane] = links[head].ids[last];
    if (last > 0)
      fill_empty_lanes(head);
    else
      {
        first[slot.cell] = links[head].next;
        unused.push_back(head);
      }
    --n_stored;
  }



  template <typename Layout>
  typename ParticleBlocks<Layout>::Parcel
  ParticleBlocks<Layout>::parcel(const ParticleSlot &slot) const
  {
    const Block &block = blocks[slot.block];
    Parcel       result;
    result.cell            = slot.cell;
    result.id              = id(slot);
    result.location        = block.point(Block::location, slot.lane);
    result.reference_point = block.point(Block::reference, slot.lane);
    for (unsigned int p = 0; p < Layout::n_properties; ++p)
      result.properties[p] = block.values[Block::properties + p][slot.lane];
    return result;
  }



  template <typename Layout>
  void
  ParticleBlocks<Layout>::overwrite(const ParticleSlot &slot,
                                    const Parcel       &parcel)
  {
    Block &block = blocks[slot.block];
    block.set_point(Block::location, slot.lane, parcel.location);
    block.set_point(Block::reference, slot.lane, parcel.reference_point);
    for (unsigned int p = 0; p < Layout::n_properties; ++p)
      block.values[Block::properties + p][slot.lane] = parcel.properties[p];
    links[slot.block].ids[slot.lane] = parcel.id;
    if (slot.lane == 0)
      fill_empty_lanes(slot.block);
  }



  template <typename Layout>
  void
  ParticleBlocks<Layout>::reserve(const unsigned int n_cells,
                                  const unsigned int n_in_cell)
  {
    const std::size_t n_blocks =
      std::size_t(n_cells) * ((n_in_cell + Lanes::n - 1) / Lanes::n);
    blocks.reserve(n_blocks);
    links.reserve(n_blocks);
  }



  template <typename Layout>
  void
  ParticleBlocks<Layout>::sort()
  {
    find_order();
    for (unsigned int place = 0; place < sources.size(); ++place)
      move_cycle(place);
    blocks.resize(blocks.size() - unused.size());
    links.resize(blocks.size());
    unused.clear();
    n_added = 0;
  }



  template <typename Layout>
  void
  ParticleBlocks<Layout>::find_order()
  {
    sources.clear();
    sources.reserve(blocks.size());
    for (const unsigned int cell : cells_in_order)
      {
        unsigned int  block = first[cell];
        unsigned int *place = &first[cell];
        while (block != none)
          {
            *place = sources.size();
            sources.push_back(block);
            place = &links[block].next;
            block = *place;
          }
      }
    sources.insert(sources.end(), unused.begin(), unused.end());
  }



  template <typename Layout>
  void
  ParticleBlocks<Layout>::move_cycle(const unsigned int place)
  {
    if (sources[place] == place)
      return;
    const Block  block = blocks[place];
    const Link   link  = links[place];
    unsigned int to    = place;
    for (unsigned int from = sources[to]; from != place; from = sources[to])
      {
        Sandglass::prefetch(blocks[sources[from]]);
        blocks[to]  = blocks[from];
        links[to]   = links[from];
        sources[to] = to;
        to          = from;
      }
    blocks[to]  = block;
    links[to]   = link;
    sources[to] = to;
  }



  template <typename Layout>
  void
  ParticleBlocks<Layout>::sort_if_mixed()
  {
    // Where no cache holds the blocks, a block out of order costs a step about
    // as much as sorting costs for each block. In the silo in flow, sorting is
    // due every twenty steps.
    constexpr unsigned int smallest_share = 4;
    if (n_added > blocks.size() / smallest_share)
      sort();
  }



  template <typename Layout>
  unsigned int
  ParticleBlocks<Layout>::add_block(const unsigned int cell)
  {
    unsigned int block;
    if (unused.empty())
      {
        block = blocks.size();
        blocks.emplace_back();
        links.emplace_back();
      }
    else
      {
        block = unused.back();
        unused.pop_back();
      }
    ++n_added;
    links[block].next    = first[cell];
    links[block].n_lanes = 0;
    first[cell]          = block;
    return block;
  }



  template <typename Layout>
  void
  ParticleBlocks<Layout>::fill_empty_lanes(const unsigned int block)
  {
    auto &values = blocks[block].values;
    for (unsigned int lane = links[block].n_lanes; lane < Lanes::n; ++lane)
      {
        for (auto &quantity : values)
          quantity[lane] = quantity[0];
        values[Block::mass][lane] = 0.;
      }
  }
} // namespace Sandglass

#endif
