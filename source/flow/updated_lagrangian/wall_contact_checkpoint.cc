#include <deal.II/base/mpi.h>

#include <sandglass/choices.h>
#include <sandglass/flow/updated_lagrangian/wall_contact.h>

#include <boost/serialization/vector.hpp>

namespace Sandglass
{
  namespace
  {
    /// What commit() has kept of one support.
    struct SavedSupport
    {
      unsigned int vertex; ///< of the filled grid
      bool         is_active;
      double       normal_force, tangential_force; ///< in N

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &vertex &is_active &normal_force &tangential_force;
      }
    };
  } // namespace



  template <int dim>
  void
  WallContact<dim>::save(boost::archive::binary_oarchive &archive) const
  {
    std::vector<SavedSupport> of_rank, all;
    for (unsigned int vertex = 0; vertex < node_at_vertex.size(); ++vertex)
      if (node_at_vertex[vertex] != numbers::invalid_unsigned_int &&
          nodes[node_at_vertex[vertex]].is_owned)
        for (const Support &support : nodes[node_at_vertex[vertex]].supports)
          of_rank.push_back({vertex,
                             support.was_active,
                             support.normal_force,
                             support.tangential_before});
    for (const auto &part : Utilities::MPI::gather(communicator, of_rank))
      all.insert(all.end(), part.begin(), part.end());
    archive << all;
  }



  template <int dim>
  void
  WallContact<dim>::load(boost::archive::binary_iarchive &archive)
  {
    std::vector<SavedSupport> all;
    archive >> all;
    for (unsigned int i = 0; i < all.size();)
      {
        const unsigned int node = node_at_vertex[all[i].vertex];
        if (node == numbers::invalid_unsigned_int)
          {
            ++i;
            continue;
          }
        for (Support &support : nodes[node].supports)
          {
            const SavedSupport &saved = all[i++];
            support.is_active = support.was_active = saved.is_active;
            support.normal_force                   = saved.normal_force;
            support.tangential_force               = support.tangential_before =
              saved.tangential_force;
          }
      }
  }



#define INSTANTIATE(dim) template class WallContact<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
