#ifndef sandglass_particles_particle_cloud_h
#define sandglass_particles_particle_cloud_h

#include <deal.II/particles/particle_handler.h>

#include <sandglass/particles/particle_properties.h>
#include <sandglass/scene/scene.h>

#include <array>
#include <vector>

namespace Sandglass
{
  using ParticleIterator = Particles::ParticleIterator<dim>;

  /// A particle that has left its cell, and where it went.
  struct Departure
  {
    /// Instead of a target cell: the particle is deleted.
    static constexpr unsigned int nowhere = numbers::invalid_unsigned_int;

    ParticleIterator particle;
    unsigned int     target_cell;
    Point<dim>       reference_point; ///< in the target cell
  };

  /**
   * The material points on deal.II's ParticleHandler, which owns identity,
   * position, cell and state (particle_properties.h). Moves particles between
   * cells and ranks.
   */
  class ParticleCloud
  {
  public:
    explicit ParticleCloud(const Scene &scene);

    Particles::ParticleHandler<dim> handler;

    using CellIterator = typename Triangulation<dim>::active_cell_iterator;

    /// The cells that this rank owns, in order of their index.
    const std::vector<CellIterator> &
    owned_cells() const
    {
      return cells_owned;
    }

    /**
     * Hand the particles over to their new cells, on whichever rank these are,
     * with id and all properties, or delete those that go nowhere. Collective.
     * Each particle may occur once, in the handler's order of each cell. The
     * new order of particles in a cell depends only on the old one and on the
     * departures, so that runs repeat exactly.
     */
    void
    move(const std::vector<Departure> &departures);

    /// A particle on its way: all that there is of it.
    struct Parcel
    {
      unsigned int                               cell;
      types::particle_index                      id;
      Point<dim>                                 location, reference_point;
      std::array<double, Property::n_properties> properties;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &cell &id &location &reference_point &properties;
      }
    };

    /// Insert a particle into a cell that this rank owns.
    void
    insert(const Parcel &parcel);

  private:
    void
    insert_on_owners();

    const Scene              &scene;
    std::vector<CellIterator> cells_all;
    std::vector<CellIterator> cells_owned;

    /// Kept between calls to avoid allocation.
    std::vector<Parcel> parcels;
  };
} // namespace Sandglass

#endif
