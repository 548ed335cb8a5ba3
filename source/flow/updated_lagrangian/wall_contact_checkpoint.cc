#include <deal.II/base/mpi.h>

#include <sandglass/choices.h>
#include <sandglass/flow/updated_lagrangian/wall_contact.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/vector.hpp>

#include <array>
#include <map>
#include <vector>

namespace Sandglass
{
  namespace
  {
<<<<<<< HEAD
    /// What commit() has kept of one node.
    template <int dim>
    struct SavedNode
    {
      unsigned int                    vertex; ///< of the scene's mesh
      std::array<bool, dim>           is_active;
      std::array<double, dim>         normal_forces;     ///< in N
      std::array<Tensor<1, dim>, dim> tangential_forces; ///< in N
=======
    /// What commit() has kept of one support.
    template <int dim>
    struct SavedSupport
    {
      unsigned int   vertex; ///< of the filled grid
      unsigned int   support;
      bool           is_active;
      double         normal_force;     ///< in N
      Tensor<1, dim> tangential_force; ///< in N
>>>>>>> f2eb0e6c5c976464671018b2a3ee5ba2dab14608

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
<<<<<<< HEAD
        archive &vertex &is_active &normal_forces &tangential_forces;
=======
        archive &vertex &support &is_active &normal_force &tangential_force;
>>>>>>> f2eb0e6c5c976464671018b2a3ee5ba2dab14608
      }
    };
  } // namespace



  template <int dim>
  void
  WallContact<dim>::save(boost::archive::binary_oarchive &archive) const
  {
<<<<<<< HEAD
    std::vector<SavedNode<dim>> of_rank, all;
    for (const Node &node : nodes)
      if (node.is_owned)
        {
          SavedNode<dim> saved{node.vertex, {}, {}, {}};
          for (unsigned int s = 0; s < dim; ++s)
            {
              saved.is_active[s]         = node.states[s].was_active;
              saved.normal_forces[s]     = node.states[s].normal_force;
              saved.tangential_forces[s] = node.states[s].tangential_before;
            }
          of_rank.push_back(saved);
        }
=======
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
>>>>>>> f2eb0e6c5c976464671018b2a3ee5ba2dab14608
    for (const auto &part : Utilities::MPI::gather(communicator, of_rank))
      all.insert(all.end(), part.begin(), part.end());
    archive << all;
  }



  template <int dim>
  void
  WallContact<dim>::load(boost::archive::binary_iarchive &archive)
  {
<<<<<<< HEAD
    std::vector<SavedNode<dim>> all;
    archive >> all;
    std::map<unsigned int, const SavedNode<dim> *> saved_at;
    for (const SavedNode<dim> &saved : all)
      saved_at[saved.vertex] = &saved;
    for (Node &node : nodes)
      {
        const SavedNode<dim> &saved = *saved_at.at(node.vertex);
        for (unsigned int s = 0; s < dim; ++s)
          {
            State &state            = node.states[s];
            state.was_active        = saved.is_active[s];
            state.is_active         = saved.is_active[s];
            state.normal_force      = saved.normal_forces[s];
            state.tangential_before = saved.tangential_forces[s];
            state.tangential_force  = saved.tangential_forces[s];
          }
=======
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
>>>>>>> f2eb0e6c5c976464671018b2a3ee5ba2dab14608
      }
  }



#define INSTANTIATE(dim)                                                  \
  template void WallContact<dim>::save(boost::archive::binary_oarchive &) \
    const;                                                                \
  template void WallContact<dim>::load(boost::archive::binary_iarchive &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
