#include <deal.II/base/mpi.h>

#include <sandglass/base/gather.h>
#include <sandglass/choices/dimensions.h>
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
    /// What commit() has kept of one node.
    template <int dim>
    struct SavedNode
    {
      unsigned int                    vertex; ///< of the scene's mesh
      std::array<bool, dim>           is_active;
      std::array<double, dim>         normal_forces;     ///< in N
      std::array<Tensor<1, dim>, dim> tangential_forces; ///< in N

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &vertex &is_active &normal_forces &tangential_forces;
      }
    };
  } // namespace



  template <int dim>
  void
  WallContact<dim>::save(boost::archive::binary_oarchive &archive) const
  {
    std::vector<SavedNode<dim>> of_rank;
    for (const Node &node : nodes)
      if (node.is_owned)
        {
          SavedNode<dim> saved{node.vertices[0], {}, {}, {}};
          for (unsigned int s = 0; s < dim; ++s)
            {
              saved.is_active[s]         = node.states[s].was_active;
              saved.normal_forces[s]     = node.states[s].normal_force;
              saved.tangential_forces[s] = node.states[s].tangential_before;
            }
          of_rank.push_back(saved);
        }
    archive << gather_on_first(of_rank, communicator);
  }



  template <int dim>
  void
  WallContact<dim>::load(boost::archive::binary_iarchive &archive)
  {
    std::vector<SavedNode<dim>> all;
    archive >> all;
    std::map<unsigned int, const SavedNode<dim> *> saved_at;
    for (const SavedNode<dim> &saved : all)
      saved_at[saved.vertex] = &saved;
    for (Node &node : nodes)
      {
        const auto entry = saved_at.find(node.vertices[0]);
        if (entry == saved_at.end())
          continue; // of a layer that is new
        const SavedNode<dim> &saved = *entry->second;
        for (unsigned int s = 0; s < dim; ++s)
          {
            State &state            = node.states[s];
            state.was_active        = saved.is_active[s];
            state.is_active         = saved.is_active[s];
            state.normal_force      = saved.normal_forces[s];
            state.tangential_before = saved.tangential_forces[s];
            state.tangential_force  = saved.tangential_forces[s];
          }
      }
  }



  template <int dim>
  std::vector<SupportSet>
  WallContact<dim>::active_supports() const
  {
    std::vector<SupportSet> active(nodes.size(), 0);
    for (unsigned int n = 0; n < nodes.size(); ++n)
      for (unsigned int s = 0; s < dim; ++s)
        if (nodes[n].states[s].is_active)
          active[n] |= 1u << s;
    return active;
  }



  template <int dim>
  void
  WallContact<dim>::set_active_supports(const std::vector<SupportSet> &active)
  {
    for (unsigned int n = 0; n < nodes.size(); ++n)
      for (unsigned int s = 0; s < dim; ++s)
        nodes[n].states[s].is_active = contains(active[n], s);
  }



#define INSTANTIATE(dim)                                                      \
  template std::vector<SupportSet> WallContact<dim>::active_supports() const; \
  template void                    WallContact<dim>::set_active_supports(     \
    const std::vector<SupportSet> &);                      \
  template void WallContact<dim>::save(boost::archive::binary_oarchive &)     \
    const;                                                                    \
  template void WallContact<dim>::load(boost::archive::binary_iarchive &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
