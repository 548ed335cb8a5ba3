#ifndef sandglass_particles_particle_blocks_h
#define sandglass_particles_particle_blocks_h

#include <sandglass/base/lanes.h>
#include <sandglass/base/prefetch.h>
#include <sandglass/particles/parcel.h>

#include <utility>
#include <vector>

namespace Sandglass
{
  /**
   * The state of up to Lanes::n particles of one cell: each quantity of them
   * side by side, as the processor takes them in. Lanes without a particle
   * hold a copy of the first without mass, which moves as that one does.
   */
  template <typename Layout>
  struct alignas(64) ParticleBlock
  {
    static constexpr int dim = Layout::dim;

    /// What a particle carries: its place, then its properties.
    enum Quantity : unsigned int
    {
      location     = 0,
      reference    = location + dim, ///< coordinates in the cell
      properties   = reference + dim,
      mass         = properties + Layout::mass,
      velocity     = properties + Layout::velocity,
      stress       = properties + Layout::stress,
      density      = properties + Layout::density,
      law_state    = properties + Layout::law_state,
      n_quantities = properties + Layout::n_properties
    };

    double values[n_quantities][Lanes::n];

    Lanes
    load(const unsigned int quantity) const
    {
      return Lanes::load(values[quantity]);
    }

    void
    store(const unsigned int quantity, const Lanes &lanes)
    {
      lanes.store(values[quantity]);
    }

    Point<dim>
    point(const Quantity quantity, const unsigned int lane) const
    {
      Point<dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = values[quantity + d][lane];
      return result;
    }

    void
    set_point(const Quantity     quantity,
              const unsigned int lane,
              const Point<dim>  &point)
    {
      for (unsigned int d = 0; d < dim; ++d)
        values[quantity + d][lane] = point[d];
    }
  };

  /// Where a particle is stored, until the next change of the blocks.
  struct ParticleSlot
  {
    unsigned int cell;
    unsigned int block;
    unsigned int lane;
  };

  /**
   * The particles as the time loop takes them: in blocks, and each cell's
   * blocks in a chain. Only the first block of a chain may have empty lanes.
   *
   * Particles come and go at a chain's first block, so a change of cell costs
   * the same however many particles there are. The order of particles in a
   * cell depends only on the order in which they came and went.
   */
  template <typename Layout>
  class ParticleBlocks
  {
  public:
    using Block  = ParticleBlock<Layout>;
    using Parcel = Sandglass::Parcel<Layout>;

    static constexpr unsigned int none = numbers::invalid_unsigned_int;

    /// @param cells  those of all `n_cells` that may hold particles (on a rank
    ///               its own), in the order in which they are gone through.
    ParticleBlocks(const unsigned int n_cells, std::vector<unsigned int> cells)
      : cells_in_order(std::move(cells))
      , first(n_cells, none)
    {}

    /// Remove all particles.
    void
    clear();

    /// Make room for as many cells with as many particles in each.
    void
    reserve(const unsigned int n_cells, const unsigned int n_in_cell);

    ParticleSlot
    insert(const Parcel &parcel);

    /**
     * Remove a particle; the last one of the chain's first block takes its
     * place. To remove several particles of a cell, go block by block along the
     * chain, and in each block take the highest lane first, so that slots are
     * valid until their turn.
     */
    void
    remove(const ParticleSlot &slot);

    Parcel
    parcel(const ParticleSlot &slot) const;

    /// Fetch a cell's first block into the cache.
    void
    prefetch(const unsigned int cell) const
    {
      if (first[cell] == none)
        return;
      Sandglass::prefetch(links[first[cell]]);
      Sandglass::prefetch(blocks[first[cell]]);
    }

    /// Copy a parcel's state, all but the cell, into a slot.
    void
    overwrite(const ParticleSlot &slot, const Parcel &parcel);

    /// Store the blocks in the order of cells and chains again, so that memory
    /// is read in order. Slots become invalid. Blocks change places where they
    /// are: a second memory for them would be half of all that particles take.
    void
    sort();

    /// Call sort() if so many blocks are out of order that it costs less than
    /// reading them.
    void
    sort_if_mixed();

    unsigned int
    n_particles() const
    {
      return n_stored;
    }

    unsigned int
    n_cells() const
    {
      return first.size();
    }

    /// The cells that may hold particles.
    const std::vector<unsigned int> &
    cells() const
    {
      return cells_in_order;
    }

    /// A cell's first block, or `none`.
    unsigned int
    first_block(const unsigned int cell) const
    {
      return first[cell];
    }

    /// The next block of the chain, or `none`.
    unsigned int
    next_block(const unsigned int block) const
    {
      return links[block].next;
    }

    /// How many lanes hold particles: the lowest.
    unsigned int
    n_lanes(const unsigned int block) const
    {
      return links[block].n_lanes;
    }

    Block &
    operator[](const unsigned int block)
    {
      return blocks[block];
    }

    const Block &
    operator[](const unsigned int block) const
    {
      return blocks[block];
    }

    types::particle_index
    id(const ParticleSlot &slot) const
    {
      return links[slot.block].ids[slot.lane];
    }

    /// Call `function(block)` for the blocks of a cell along the chain.
    template <typename Function>
    void
    for_each_block_in_cell(const unsigned int cell,
                           const Function    &function) const
    {
      for (unsigned int block = first[cell]; block != none;
           block              = links[block].next)
        function(block);
    }

    /// Call `function(slot)` for all particles, cell by cell in the order of
    /// for_each_in_cell().
    template <typename Function>
    void
    for_each(const Function &function) const
    {
      for (const unsigned int cell : cells_in_order)
        for_each_in_cell(cell, function);
    }

    /**
     * Call `function(slot)` for the particles of a cell in the order in which
     * insert() stores them in the same way again.
     */
    template <typename Function>
    void
    for_each_in_cell(const unsigned int cell, const Function &function) const
    {
      // A chain is short, and read from its end.
      const unsigned int block = first[cell];
      if (block != none)
        for_each_from_end(cell, block, function);
    }

  private:
    /// What of a block the loop over particles doesn't need.
    struct Link
    {
      unsigned int          next;
      unsigned int          n_lanes;
      types::particle_index ids[Lanes::n];
    };

    template <typename Function>
    void
    for_each_from_end(const unsigned int cell,
                      const unsigned int block,
                      const Function    &function) const
    {
      if (links[block].next != none)
        for_each_from_end(cell, links[block].next, function);
      for (unsigned int lane = 0; lane < links[block].n_lanes; ++lane)
        function(ParticleSlot{cell, block, lane});
    }

    /// An empty block at the head of a cell's chain.
    unsigned int
    add_block(const unsigned int cell);

    /// Which block goes where when they are sorted, unused ones to the end; the
    /// chains are told their blocks' new places.
    void
    find_order();

    /// Move blocks along the cycle of `sources` that `place` is in.
    void
    move_cycle(const unsigned int place);

    /// Copy the first lane, without mass, into the empty ones.
    void
    fill_empty_lanes(const unsigned int block);

    const std::vector<unsigned int> cells_in_order;

    std::vector<Block>        blocks;
    std::vector<Link>         links;
    std::vector<unsigned int> first;  ///< block of each cell
    std::vector<unsigned int> unused; ///< blocks
    unsigned int              n_stored = 0;
    unsigned int              n_added  = 0; ///< blocks since sort()

    /// Kept between calls to avoid allocation: the block that goes to each
    /// place.
    std::vector<unsigned int> sources;
  };
} // namespace Sandglass

#include <sandglass/particles/particle_blocks.templates.h>

#endif
