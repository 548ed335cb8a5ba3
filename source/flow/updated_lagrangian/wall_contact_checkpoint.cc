#include <deal.II/base/mpi.h>

#include <sandglass/choices.h>
#include <sandglass/flow/updated_lagrangian/wall_contact.h>

#include <boost/serialization/vector.hpp>

namespace Sandglass
{
  namespace
  {
    /// What commit() has kept of one support.
    template <int dim>
    struct SavedSupport
    {
      unsigned int   vertex; ///< of the filled grid
      unsigned int   support;
      bool           is_active;
      double         normal_force;     ///< in N
      Tensor<1, dim> tangential_force; ///< in N

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &vertex &support &is_active &normal_force &tangential_force;
      }
    };
  } // namespace



  template <int dim>
  void
  WallContact<dim>::save(boost::archive::binary_oarchive &archive) const
  {
    std::vector<SavedSupport<dim>> of_rank, all;
    for (unsigned int vertex = 0; vertex < node_at_vertex.size(); ++vertex)
      {
        const unsigned int n = node_at_vertex[vertex];
        if (n == numbers::invalid_unsigned_int || !nodes[n].is_owned)
          continue;
        for (unsigned int s = 0; s < nodes[n].supports.size(); ++s)
          {
            const State &state = nodes[n].states[s];
            of_rank.push_back({vertex,
                               s,
                               state.was_active,
                               state.normal_force,
                               state.tangential_before});
          }
      }
    for (const auto &part : Utilities::MPI::gather(communicator, of_rank))
      all.insert(all.end(), part.begin(), part.end());
    archive << all;
  }



  template <int dim>
  void
  WallContact<dim>::load(boost::archive::binary_iarchive &archive)
  {
    std::vector<SavedSupport<dim>> all;
    archive >> all;
    for (const SavedSupport<dim> &saved : all)
      {
        const unsigned int n = node_at_vertex[saved.vertex];
        if (n == numbers::invalid_unsigned_int)
          continue;
        State &state    = nodes[n].states[saved.support];
        state.is_active = state.was_active = saved.is_active;
        state.normal_force                 = saved.normal_force;
        state.tangential_force             = state.tangential_before =
          saved.tangential_force;
      }
  }



#define INSTANTIATE(dim) template class WallContact<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
