#ifndef sandglass_flow_particle_in_cell_stage_checkpoint_templates_h
#define sandglass_flow_particle_in_cell_stage_checkpoint_templates_h

#include <sandglass/base/gather.h>
#include <sandglass/flow/particle_in_cell/particle_stage.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

namespace Sandglass
{
  /// Sums that each rank keeps for itself.
  struct StageSums
  {
    double plastic_dissipation, friction_dissipation, wall_work; ///< in J
    CompensatedSum      mass_discharged, mass_lost, mass_fed;    ///< in kg
    std::vector<double> mass_by_outlet; ///< removed below each outlet

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &plastic_dissipation &friction_dissipation &wall_work
        &mass_discharged &mass_lost &mass_fed &mass_by_outlet;
    }

    StageSums &
    operator+=(const StageSums &other)
    {
      plastic_dissipation += other.plastic_dissipation;
      friction_dissipation += other.friction_dissipation;
      wall_work += other.wall_work;
      mass_discharged += other.mass_discharged;
      mass_lost += other.mass_lost;
      mass_fed += other.mass_fed;
      for (unsigned int i = 0; i < mass_by_outlet.size(); ++i)
        mass_by_outlet[i] += other.mass_by_outlet[i];
      return *this;
    }
  };

  template <typename Layout>
  void
  ParticleStage<Layout>::save(boost::archive::binary_oarchive &archive) const
  {
    const MPI_Comm communicator = scene.communicator;

    const StageSums sums_of_rank{plastic_dissipation,
                                 contact.friction_dissipation(),
                                 contact.wall_work(),
                                 removed.discharged,
                                 removed.lost,
                                 mass_fed,
                                 outlets.removed};
    const auto      sums =
      gather_on_first(std::vector<StageSums>{sums_of_rank}, communicator);

    std::vector<Parcel> of_rank; // in each cell's order
    cloud.blocks().for_each([&](const ParticleSlot &slot) {
      of_rank.push_back(cloud.blocks().parcel(slot));
    });
    const auto parcels   = gather_on_first(of_rank, communicator);
    const auto cell_sums = gather_on_first(pack_cell_sums(), communicator);

    const auto fed = gather_on_first(fed_numbers(), communicator);

    archive << time << control << sums << parcels << cell_sums << fed;
    contact.save(archive);
  }



  template <typename Layout>
  void
  ParticleStage<Layout>::load(boost::archive::binary_iarchive &archive)
  {
    const unsigned int rank =
      Utilities::MPI::this_mpi_process(scene.communicator);

    std::vector<StageSums> sums;
    std::vector<Parcel>    parcels;
    std::vector<double>    cell_sums;
    FedNumbers             fed;
    archive >> time >> control >> sums >> parcels >> cell_sums >> fed;
    set_fed_numbers(fed);
    contact.load(archive);

    // The rank's own sums, or on another number of ranks all sums on rank 0.
    StageSums own{};
    own.mass_by_outlet.assign(outlets.removed.size(), 0.);
    if (sums.size() == Utilities::MPI::n_mpi_processes(scene.communicator))
      own = sums[rank];
    else if (rank == 0)
      for (const StageSums &of_rank : sums)
        own += of_rank;
    plastic_dissipation = own.plastic_dissipation;
    removed             = {own.mass_discharged, own.mass_lost};
    outlets.removed     = own.mass_by_outlet;
    mass_fed            = own.mass_fed;
    contact.set_energies(own.friction_dissipation, own.wall_work);

    cloud.clear();
    for (const Parcel &parcel : parcels)
      if (scene.cell_owners[parcel.cell] == rank)
        cloud.insert(parcel);
    unpack_cell_sums(cell_sums);
  }
} // namespace Sandglass

#endif
