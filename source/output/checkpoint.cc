#include <deal.II/base/mpi.h>

#include <sandglass/output/checkpoint.h>

#include <algorithm>
#include <map>

namespace Sandglass
{
  namespace
  {
    /// What all ranks have, in order of the ranks, on rank 0.
    template <typename T>
    std::vector<T>
    gather(const std::vector<T> &of_rank, const MPI_Comm communicator)
    {
      if (Utilities::MPI::n_mpi_processes(communicator) == 1)
        return of_rank;
      std::vector<T> all;
      for (const auto &part : Utilities::MPI::gather(communicator, of_rank))
        all.insert(all.end(), part.begin(), part.end());
      return all;
    }



    std::vector<Parcel>
    pack_particles(ParticleStage &stage)
    {
      const ParticleBlocks &blocks = stage.cloud.blocks();
      std::vector<Parcel>   parcels;
      blocks.for_each([&](const ParticleSlot &slot) {
        parcels.push_back(blocks.parcel(slot));
      });
      // A resumed run sums over the particles anew; for the same rounding, so
      // does this one.
      stage.cloud.start_new_edition();
      return parcels;
    }



    /// Vertex of each node of this rank's cells.
    std::map<types::global_dof_index, unsigned int>
    vertices_of_nodes(const Scene &scene)
    {
      std::map<types::global_dof_index, unsigned int> vertices;
      for (const auto &cell : scene.dof_handler.active_cell_iterators())
        if (!cell->is_artificial())
          for (const unsigned int v : cell->vertex_indices())
            vertices[cell->vertex_dof_index(v, 0)] = cell->vertex_index(v);
      return vertices;
    }



    std::vector<Checkpoint::NodeState>
    pack_nodes(ParticleStage &stage)
    {
      const auto vertices = vertices_of_nodes(stage.scene);
      const auto dofs     = stage.contact.node_dofs();
      const auto sums     = stage.contact.sums();

      std::vector<Checkpoint::NodeState> nodes;
      for (unsigned int n = 0; n < dofs.size(); ++n)
        nodes.push_back(
          {vertices.at(dofs[n]), stage.contact.memories[n], sums.impulses[n]});
      return nodes;
    }



    void
    restore_particles(const std::vector<Parcel> &particles,
                      ParticleStage             &stage)
    {
      const unsigned int rank =
        Utilities::MPI::this_mpi_process(stage.scene.communicator);
      stage.cloud.clear();
      for (const auto &parcel : particles)
        if (stage.scene.cell_owners[parcel.cell] == rank)
          stage.cloud.insert(parcel);
    }



    /// The rank's own sums, or on another number of ranks all sums on rank 0.
    Checkpoint::RankSums
    sums_of_rank(const Checkpoint &checkpoint, const MPI_Comm communicator)
    {
      const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
      if (checkpoint.rank_sums.size() ==
          Utilities::MPI::n_mpi_processes(communicator))
        return checkpoint.rank_sums[rank];

      Checkpoint::RankSums total{};
      if (rank == 0)
        for (const auto &sums : checkpoint.rank_sums)
          {
            total.plastic_dissipation += sums.plastic_dissipation;
            total.friction_dissipation += sums.friction_dissipation;
            total.mass_discharged += sums.mass_discharged;
            total.mass_lost += sums.mass_lost;
          }
      return total;
    }



    void
    restore_contact(const Checkpoint &checkpoint,
                    const double      friction_dissipation,
                    ParticleStage    &stage)
    {
      std::map<unsigned int, const Checkpoint::NodeState *> state_at;
      for (const auto &node : checkpoint.nodes)
        state_at[node.vertex] = &node;

      const auto    vertices = vertices_of_nodes(stage.scene);
      const auto    dofs     = stage.contact.node_dofs();
      Contact::Sums sums{friction_dissipation, checkpoint.impulse_time, {}};
      for (unsigned int n = 0; n < dofs.size(); ++n)
        {
          const auto &state         = *state_at.at(vertices.at(dofs[n]));
          stage.contact.memories[n] = state.friction;
          sums.impulses.push_back(state.impulses);
        }
      stage.contact.set_sums(sums);
    }



    /// All but the particles; complete on rank 0.
    Checkpoint
    take_without_particles(ParticleStage &stage)
    {
      const MPI_Comm communicator = stage.scene.communicator;
      const auto    &removed      = stage.removed_mass();
      const std::vector<Checkpoint::RankSums> rank_sums = {
        {stage.plastic_dissipation,
         stage.contact.friction_dissipation(),
         removed.discharged,
         removed.lost}};

      Checkpoint checkpoint;
      checkpoint.clock                   = stage.clock;
      checkpoint.automatic_time_step     = stage.automatic_time_step;
      checkpoint.last_local_eigenvalue   = stage.last_local_eigenvalue;
      checkpoint.last_critical_time_step = stage.last_critical_time_step;
      checkpoint.impulse_time            = stage.contact.sums().time;
      checkpoint.rank_sums               = gather(rank_sums, communicator);
      checkpoint.nodes = gather(pack_nodes(stage), communicator);
      return checkpoint;
    }



    void
    restore_without_particles(const Checkpoint &checkpoint,
                              ParticleStage    &stage)
    {
      const auto sums = sums_of_rank(checkpoint, stage.scene.communicator);

      stage.clock                     = checkpoint.clock;
      stage.automatic_time_step       = checkpoint.automatic_time_step;
      stage.last_local_eigenvalue     = checkpoint.last_local_eigenvalue;
      stage.last_critical_time_step   = checkpoint.last_critical_time_step;
      stage.plastic_dissipation       = sums.plastic_dissipation;
      stage.removed_mass().discharged = sums.mass_discharged;
      stage.removed_mass().lost       = sums.mass_lost;
      restore_contact(checkpoint, sums.friction_dissipation, stage);
    }
  } // namespace



  Checkpoint
  take_checkpoint(ParticleStage &stage)
  {
    Checkpoint checkpoint   = take_without_particles(stage);
    checkpoint.cell_weights = stage.scene.cell_weights;
    checkpoint.waiting      = stage.waiting;
    checkpoint.particles =
      gather(pack_particles(stage), stage.scene.communicator);
    return checkpoint;
  }



  void
  restore(const Checkpoint &checkpoint, ParticleStage &stage)
  {
    restore_without_particles(checkpoint, stage);
    stage.waiting = checkpoint.waiting;
    restore_particles(checkpoint.particles, stage);
  }



  void
  hand_over(ParticleStage &from, ParticleStage &to)
  {
    restore_without_particles(Utilities::MPI::broadcast(from.scene.communicator,
                                                        take_without_particles(
                                                          from)),
                              to);
    to.particle_steps = from.particle_steps;

    std::vector<ParticleSlot> arrivals;
    to.cloud.clear();
    to.cloud.insert(pack_particles(from), arrivals);
  }
} // namespace Sandglass
