#include <deal.II/base/mpi.h>

#include <sandglass/particles/particle_cloud.h>

#include <algorithm>
#include <map>

namespace Sandglass
{
  ParticleCloud::ParticleCloud(const Scene &scene)
    : handler(scene.triangulation, scene.mapping, Property::n_properties)
    , scene(scene)
  {
    for (const auto &cell : scene.triangulation.active_cell_iterators())
      {
        cells_all.push_back(cell);
        if (cell->is_locally_owned())
          cells_owned.push_back(cell);
      }
  }



  void
  ParticleCloud::move(const std::vector<Departure> &departures)
  {
    // Copies first: the handler's arrays may move when particles are inserted,
    // and places that become free are taken again.
    parcels.clear();
    for (const auto &departure : departures)
      if (departure.target_cell != Departure::nowhere)
        {
          const auto &particle   = departure.particle;
          const auto  properties = particle->get_properties();
          parcels.push_back({departure.target_cell,
                             particle->get_id(),
                             particle->get_location(),
                             departure.reference_point,
                             {}});
          std::copy(properties.begin(),
                    properties.end(),
                    parcels.back().properties.begin());
        }

    // Removal fills the gap with the cell's last particle. Backwards, the
    // iterators of the same cell that are still to come stay valid.
    for (auto departure = departures.rbegin(); departure != departures.rend();
         ++departure)
      handler.remove_particle(departure->particle);

    if (Utilities::MPI::n_mpi_processes(scene.communicator) == 1)
      for (const Parcel &parcel : parcels)
        insert(parcel);
    else
      insert_on_owners();
  }



  void
  ParticleCloud::insert(const Parcel &parcel)
  {
    handler.insert_particle(parcel.location,
                            parcel.reference_point,
                            parcel.id,
                            cells_all[parcel.cell],
                            ArrayView<const double>(parcel.properties.data(),
                                                    parcel.properties.size()));
  }



  void
  ParticleCloud::insert_on_owners()
  {
    const unsigned int this_rank =
      Utilities::MPI::this_mpi_process(scene.communicator);

    std::map<unsigned int, std::vector<Parcel>> outgoing;
    for (const Parcel &parcel : parcels)
      {
        const unsigned int owner = scene.cell_owners[parcel.cell];
        if (owner == this_rank)
          insert(parcel);
        else
          outgoing[owner].push_back(parcel);
      }
    for (const auto &[rank, incoming] :
         Utilities::MPI::some_to_some(scene.communicator, outgoing))
      for (const Parcel &parcel : incoming)
        insert(parcel);
  }
} // namespace Sandglass
