#ifndef sandglass_flow_particle_in_cell_outlet_masses_h
#define sandglass_flow_particle_in_cell_outlet_masses_h

#include <deal.II/base/mpi.h>

#include <sandglass/particles/particle_blocks.h>
#include <sandglass/scene/outlets.h>

#include <algorithm>
#include <vector>

namespace Sandglass
{
  /// Tells apart what passes several outlets: what still falls below each, and
  /// what has been removed there. With one outlet it does nothing.
  template <int dim>
  class OutletMasses
  {
  public:
    explicit OutletMasses(const Mesh<dim> &mesh)
    {
      const std::vector<Outlet> outlets = find_outlets(mesh);
      if (outlets.size() < 2)
        return;
      removed.assign(outlets.size(), 0.);
      outlet_of_cell.assign(mesh.cells.size(), none);
      for (unsigned int i = 0; i < outlets.size(); ++i)
        for (const unsigned int cell : outlets[i].cells)
          outlet_of_cell[cell] = i;
    }

    bool
    is_on() const
    {
      return !removed.empty();
    }

    /// Count the particles that Relocation is about to remove.
    /// @param strays  particles on their way out of their cells.
    template <typename Layout, typename Geometry>
    void
    count_removed(const std::vector<Parcel<Layout>> &strays,
                  const Geometry                    &geometry)
    {
      for (const Parcel<Layout> &stray : strays)
        {
          if (outlet_of_cell[stray.cell] == none)
            continue;
          const auto location = geometry.find(stray.location, stray.cell);
          if (location.kind == Geometry::Location::Kind::outside &&
              is_open(location.part.role))
            removed[outlet_of_cell[stray.cell]] +=
              stray.properties[Layout::mass];
        }
    }

    void
    forget_removed()
    {
      std::fill(removed.begin(), removed.end(), 0.);
    }

    /// What has passed each outlet, in kg; nothing where there is only one.
    /// Collective.
    template <typename Layout>
    std::vector<double>
    masses(const ParticleBlocks<Layout> &blocks,
           const MPI_Comm                communicator) const
    {
      using Block = ParticleBlock<Layout>;
      if (!is_on())
        return {};
      std::vector<double> result = removed;
      for (const unsigned int cell : blocks.cells())
        if (outlet_of_cell[cell] != none)
          blocks.for_each_in_cell(cell, [&](const ParticleSlot &slot) {
            result[outlet_of_cell[cell]] +=
              blocks[slot.block].values[Block::mass][slot.lane];
          });
      Utilities::MPI::sum(result, communicator, result);
      return result;
    }

    /// Below each outlet on this rank since the start, in kg.
    std::vector<double> removed;

  private:
    static constexpr unsigned int none = numbers::invalid_unsigned_int;

    /// Of each cell; `none` in the silo.
    std::vector<unsigned int> outlet_of_cell;
  };
} // namespace Sandglass

#endif
