#ifndef sandglass_flow_particle_in_cell_sums_by_cell_h
#define sandglass_flow_particle_in_cell_sums_by_cell_h

#include <sandglass/base/instruction_sets.h>
#include <sandglass/base/prefetch.h>
#include <sandglass/flow/particle_in_cell/cell_kernel.h>
#include <sandglass/particles/cell_geometry.h>
#include <sandglass/particles/particle_state.h>

#include <vector>

namespace Sandglass
{
  /**
   * Sums over the particles of each cell. The pass over the particles leaves
   * them for the next step; what changes particles otherwise has to keep them
   * up to date.
   *
   * @tparam Sums  of one cell, Sums<Setting, Number>: an array `values`,
   *               clear(), and add(particles, smallest_density, shape).
   */
  template <typename Setting, template <typename, typename> class Sums>
  class SumsByCell
  {
  public:
    using Geometry = CellGeometry<Setting::cell_type>;
    using Blocks   = ParticleBlocks<typename Setting::Layout>;
    using OfCell   = Sums<Setting, double>;
    using OfBlocks = Sums<Setting, Lanes>;

    /// @param smallest_density  handed on to Sums::add(), in kg/m^3.
    SumsByCell(const Geometry &geometry, const double smallest_density)
      : smallest_density(smallest_density)
      , geometry(geometry)
      , cells(geometry.n_cells())
    {}

    /// Sum over all particles anew.
    void
    compute(const Blocks &blocks)
    {
      run_with_widest_vectors([&]() {
        for_each_filled_cell(blocks, [&](const unsigned int cell) {
          compute(blocks, cell);
        });
      });
    }

    /// Sum over the particles of one cell anew.
    void
    compute(const Blocks &blocks, const unsigned int cell)
    {
      OfBlocks sums;
      sums.clear();
      blocks.for_each_block_in_cell(cell, [&](const unsigned int block) {
        sums.add(load_state(blocks[block]),
                 smallest_density,
                 geometry.shape(cell));
      });
      set(cell, sums);
    }

    /// The sums of a cell from those of its blocks.
    void
    set(const unsigned int cell, const OfBlocks &sums)
    {
      sum_lanes(sums.values, cells[cell].values);
    }

    /// Set the sums of a cell to stored numbers; returns the first one behind.
    template <typename Iterator>
    Iterator
    unpack(const unsigned int cell, const Iterator next)
    {
      auto &values = cells[cell].values;
      std::copy_n(next, values.size(), values.begin());
      return next + values.size();
    }

    /// Add particles that have just come into their cells, in this order.
    void
    add(const Blocks &blocks, const std::vector<ParticleSlot> &arrivals)
    {
      for (std::size_t n = 0; n < arrivals.size(); ++n)
        {
          if (n + prefetch_distance < arrivals.size())
            {
              const unsigned int cell = arrivals[n + prefetch_distance].cell;
              blocks.prefetch(cell);
              geometry.prefetch(cell);
              prefetch(cells[cell]);
            }
          const ParticleSlot &slot = arrivals[n];
          const bool          is_first =
            slot.lane == 0 && blocks.next_block(slot.block) == Blocks::none;
          if (is_first)
            cells[slot.cell].clear();
          cells[slot.cell].add(load_state(blocks[slot.block], slot.lane),
                               smallest_density,
                               geometry.shape(slot.cell));
        }
    }

    /// The sums of a cell that holds particles; those of empty cells are old.
    const OfCell &
    operator[](const unsigned int cell) const
    {
      return cells[cell];
    }

    const double smallest_density;

  private:
    const Geometry     &geometry;
    std::vector<OfCell> cells;
  };
} // namespace Sandglass

#endif
