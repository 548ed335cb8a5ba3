#ifndef sandglass_particles_particle_cloud_h
#define sandglass_particles_particle_cloud_h

#include <deal.II/particles/particle_handler.h>

#include <sandglass/particles/particle_blocks.h>
#include <sandglass/scene/scene.h>

#include <vector>

namespace Sandglass
{
  /**
   * The material points. The blocks own them; deal.II's ParticleHandler is a
   * view of them, made from the blocks when somebody asks for it, for exchange
   * and export by deal.II's means. Moves particles between cells and ranks.
   */
  template <typename Layout>
  class ParticleCloud
  {
  public:
    static constexpr int dim = Layout::dim;

    using Scene        = Sandglass::Scene<dim>;
    using Blocks       = ParticleBlocks<Layout>;
    using Parcel       = Sandglass::Parcel<Layout>;
    using Handler      = Particles::ParticleHandler<dim>;
    using CellIterator = typename Triangulation<dim>::active_cell_iterator;

    explicit ParticleCloud(const Scene &scene);

    /// The particles as they are now, in the order of the blocks. Collective.
    const Handler &
    handler() const;

    /// Call `change(handler)`, which may change, add or remove particles. The
    /// handler's memory, as much as a particle has in its block, is freed then.
    /// Collective.
    template <typename Change>
    void
    edit(const Change &change)
    {
      handler();
      change(particle_handler);
      load_blocks();
      particle_handler.clear_particles();
    }

    const Blocks &
    blocks() const
    {
      return particle_blocks;
    }

    /// The blocks, for those who change particles in their cells.
    Blocks &
    change_blocks()
    {
      handler_is_current = false;
      return particle_blocks;
    }

    /// The cells that this rank owns, in order of their index.
    const std::vector<CellIterator> &
    owned_cells() const
    {
      return cells_owned;
    }

    unsigned int
    n_locally_owned_particles() const
    {
      return particle_blocks.n_particles();
    }

    /**
     * Hand particles over to their cells, on whichever rank these are.
     * Collective. The order of particles in a cell depends only on the order in
     * which they came and went, so that runs repeat exactly.
     *
     * @param[out] arrivals  where this rank's new particles are, in the order
     *                       in which they came.
     */
    void
    insert(const std::vector<Parcel> &parcels,
           std::vector<ParticleSlot> &arrivals);

    /// Insert a particle into a cell that this rank owns.
    ParticleSlot
    insert(const Parcel &parcel);

    void
    clear();

  private:
    void
    load_blocks();

    void
    update_handler() const;

    void
    update_handler(const CellIterator &cell) const;

    const Scene              &scene;
    std::vector<CellIterator> cells_all;
    std::vector<CellIterator> cells_owned;

    Blocks particle_blocks;

    // The view that handler() makes.
    mutable Handler particle_handler;
    mutable bool    handler_is_current = false;

    /// Kept between calls to avoid allocation.
    mutable std::vector<Parcel> parcels_of_cell;
  };
} // namespace Sandglass

#include <sandglass/particles/particle_cloud.templates.h>

#endif
