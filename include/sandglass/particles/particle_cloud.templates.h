#ifndef sandglass_particles_particle_cloud_templates_h
#define sandglass_particles_particle_cloud_templates_h

#include <deal.II/base/mpi.h>

#include <sandglass/base/prefetch.h>
#include <sandglass/particles/particle_cloud.h>

#include <algorithm>
#include <map>

namespace Sandglass
{
  /// Of the cells that this rank owns, in order.
  template <int dim>
  std::vector<unsigned int>
  indices_of_owned_cells(const Scene<dim> &scene)
  {
    std::vector<unsigned int> cells;
    for (const auto &cell : scene.triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        cells.push_back(cell->active_cell_index());
    return cells;
  }



  template <typename Layout>
  ParticleCloud<Layout>::ParticleCloud(const Scene &scene)
    : scene(scene)
    , particle_blocks(scene.triangulation.n_active_cells(),
                      indices_of_owned_cells(scene))
    , particle_handler(scene.triangulation, scene.mapping, Layout::n_properties)
  {
    for (const auto &cell : scene.triangulation.active_cell_iterators())
      cells_all.push_back(cell);
    for (const unsigned int cell : particle_blocks.cells())
      cells_owned.push_back(cells_all[cell]);
  }



  template <typename Layout>
  const typename ParticleCloud<Layout>::Handler &
  ParticleCloud<Layout>::handler() const
  {
    if (Utilities::MPI::max(handler_is_current ? 0 : 1, scene.communicator) > 0)
      update_handler();
    return particle_handler;
  }



  template <typename Layout>
  void
  ParticleCloud<Layout>::update_handler() const
  {
    for (const auto &cell : cells_owned)
      update_handler(cell);
    particle_handler.update_cached_numbers();
    handler_is_current = true;
  }



  template <typename Layout>
  void
  ParticleCloud<Layout>::update_handler(const CellIterator &cell) const
  {
    parcels_of_cell.clear();
    particle_blocks.for_each_in_cell(cell->active_cell_index(),
                                     [this](const ParticleSlot &slot) {
                                       parcels_of_cell.push_back(
                                         particle_blocks.parcel(slot));
                                     });

    // Particles that the handler has there already take on the new states.
    auto               particles = particle_handler.particles_in_cell(cell);
    const unsigned int n_stored =
      std::distance(particles.begin(), particles.end());
    for (unsigned int n = n_stored; n > parcels_of_cell.size(); --n)
      {
        particles = particle_handler.particles_in_cell(cell);
        particle_handler.remove_particle(std::next(particles.begin(), n - 1));
      }
    for (unsigned int n = n_stored; n < parcels_of_cell.size(); ++n)
      particle_handler.insert_particle({}, {}, 0, cell);

    auto parcel = parcels_of_cell.begin();
    particles   = particle_handler.particles_in_cell(cell);
    for (auto particle = particles.begin(); particle != particles.end();
         ++particle, ++parcel)
      {
        particle->set_id(parcel->id);
        particle->set_location(parcel->location);
        particle->set_reference_location(parcel->reference_point);
        particle->set_properties(
          ArrayView<const double>(parcel->properties.data(),
                                  parcel->properties.size()));
      }
  }



  template <typename Layout>
  void
  ParticleCloud<Layout>::load_blocks()
  {
    particle_handler.update_cached_numbers();
    particle_blocks.clear();
    for (const auto &cell : cells_owned)
      for (const auto &particle : particle_handler.particles_in_cell(cell))
        {
          Parcel     parcel{cell->active_cell_index(),
                        particle.get_id(),
                        particle.get_location(),
                        particle.get_reference_location(),
                        {}};
          const auto properties = particle.get_properties();
          std::copy(properties.begin(),
                    properties.end(),
                    parcel.properties.begin());
          particle_blocks.insert(parcel);
        }
    handler_is_current = false;
  }



  template <typename Layout>
  void
  ParticleCloud<Layout>::insert(const std::vector<Parcel> &parcels,
                                std::vector<ParticleSlot> &arrivals)
  {
    arrivals.clear();
    handler_is_current = false;
    const bool is_alone =
      Utilities::MPI::n_mpi_processes(scene.communicator) == 1;
    const unsigned int this_rank =
      Utilities::MPI::this_mpi_process(scene.communicator);

    std::map<unsigned int, std::vector<Parcel>> outgoing;
    for (std::size_t n = 0; n < parcels.size(); ++n)
      {
        // The cells are neighbours of those that the particles have left, but
        // on fine meshes no cache has kept them.
        if (n + prefetch_distance < parcels.size())
          particle_blocks.prefetch(parcels[n + prefetch_distance].cell);
        const unsigned int owner =
          is_alone ? this_rank : scene.cell_owners[parcels[n].cell];
        if (owner == this_rank)
          arrivals.push_back(particle_blocks.insert(parcels[n]));
        else
          outgoing[owner].push_back(parcels[n]);
      }
    if (is_alone)
      return;
    for (const auto &[rank, incoming] :
         Utilities::MPI::some_to_some(scene.communicator, outgoing))
      for (const Parcel &parcel : incoming)
        arrivals.push_back(particle_blocks.insert(parcel));
  }



  template <typename Layout>
  ParticleSlot
  ParticleCloud<Layout>::insert(const Parcel &parcel)
  {
    return change_blocks().insert(parcel);
  }



  template <typename Layout>
  void
  ParticleCloud<Layout>::clear()
  {
    change_blocks().clear();
  }
} // namespace Sandglass

#endif
