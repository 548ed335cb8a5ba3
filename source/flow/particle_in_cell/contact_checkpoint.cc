// What contact saves for a flow that goes on later.

#include <deal.II/base/mpi.h>

#include <sandglass/base/gather.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/particle_in_cell/contact.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <map>

namespace Sandglass
{
  namespace
  {
    /// What a checkpoint has of one node.
    template <int dim>
    struct SavedNode
    {
      unsigned int                            vertex;  ///< of the scene's mesh
      std::vector<Tensor<1, dim>>             normals; ///< of its supports
      std::array<FrictionMemory<dim>, dim>    friction;
      typename WallImpulseSums<dim>::NodeSums impulses;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &vertex &normals &friction &impulses;
      }
    };



    template <int dim>
    std::vector<Tensor<1, dim>>
    normals_of(const BoundaryNode<dim> &node)
    {
      std::vector<Tensor<1, dim>> normals;
      for (const Support<dim> &support : node.supports)
        normals.push_back(support.normal);
      return normals;
    }



    /// What a node had in the directions of the supports that it has now. They
    /// are others where a gate has been opened or closed since.
    template <int dim, typename Values>
    Values
    in_directions(const std::vector<Tensor<1, dim>> &now,
                  const std::vector<Tensor<1, dim>> &saved,
                  const Values                      &values)
    {
      constexpr double same_direction = 1. - 1e-8;
      if (now == saved)
        return values;
      Values result{};
      for (unsigned int s = 0; s < now.size(); ++s)
        for (unsigned int t = 0; t < saved.size(); ++t)
          if (now[s] * saved[t] > same_direction)
            result[s] = values[t];
      return result;
    }
  } // namespace



  template <int dim>
  void
  Contact<dim>::save(boost::archive::binary_oarchive &archive) const
  {
    std::vector<SavedNode<dim>> of_rank;
    for (unsigned int n = 0; n < nodes.size(); ++n)
      of_rank.push_back(
        {nodes[n].vertex, normals_of(nodes[n]), memories[n], sums.at_nodes[n]});
    archive << summed_time << time_step
            << gather_on_first(of_rank, scene.communicator)
            << Utilities::MPI::gather(scene.communicator, sums.on_particles);
  }



  template <int dim>
  void
  Contact<dim>::load(boost::archive::binary_iarchive &archive)
  {
    std::vector<SavedNode<dim>>                             saved;
    std::vector<typename WallImpulseSums<dim>::FaceSumsMap> on_particles;
    archive >> summed_time >> time_step >> saved >> on_particles;

    std::map<unsigned int, const SavedNode<dim> *> saved_at;
    for (const SavedNode<dim> &node : saved)
      saved_at[node.vertex] = &node;
    for (unsigned int n = 0; n < nodes.size(); ++n)
      {
        memories[n]      = {};
        sums.at_nodes[n] = {};
        const auto entry = saved_at.find(nodes[n].vertex);
        if (entry == saved_at.end())
          continue; // on a gate that has closed
        const SavedNode<dim> &node    = *entry->second;
        const auto            normals = normals_of(nodes[n]);
        memories[n]      = in_directions(normals, node.normals, node.friction);
        sums.at_nodes[n] = in_directions(normals, node.normals, node.impulses);
      }

    // A rank's own sums, or on another number of ranks all on rank 0.
    const unsigned int rank =
      Utilities::MPI::this_mpi_process(scene.communicator);
    sums.on_particles.clear();
    if (on_particles.size() ==
        Utilities::MPI::n_mpi_processes(scene.communicator))
      sums.on_particles = on_particles[rank];
    else if (rank == 0)
      for (const auto &of_rank : on_particles)
        for (const auto &[face, impulses] : of_rank)
          for (unsigned int v = 0; v < impulses.size(); ++v)
            sums.on_particles[face][v] += impulses[v];
  }



#define INSTANTIATE(dim)                                                     \
  template void Contact<dim>::save(boost::archive::binary_oarchive &) const; \
  template void Contact<dim>::load(boost::archive::binary_iarchive &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
