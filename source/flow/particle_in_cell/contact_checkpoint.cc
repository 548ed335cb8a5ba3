// What contact saves for a flow that goes on later.

#include <deal.II/base/mpi.h>

#include <sandglass/choices.h>
#include <sandglass/flow/particle_in_cell/contact.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/vector.hpp>

#include <map>

namespace Sandglass
{
  namespace
  {
    /// What a node remembers of its contact.
    struct NodeState
    {
      /// Vertex of the triangulation, the same on any number of ranks.
      unsigned int                  vertex;
      std::array<FrictionMemory, 2> friction;
      /// Normal and tangential impulse of each support, in N s.
      std::array<double, 4> impulses;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &vertex &friction &impulses;
      }
    };



    /// Vertex of each node of this rank's cells.
    template <int dim>
    std::map<types::global_dof_index, unsigned int>
    vertices_of_nodes(const Scene<dim> &scene)
    {
      std::map<types::global_dof_index, unsigned int> vertices;
      for (const auto &cell : scene.dof_handler.active_cell_iterators())
        if (!cell->is_artificial())
          for (const unsigned int v : cell->vertex_indices())
            vertices[cell->vertex_dof_index(v, 0)] = cell->vertex_index(v);
      return vertices;
    }
  } // namespace



  template <int dim>
  void
  Contact<dim>::save(boost::archive::binary_oarchive &archive) const
  {
    const auto             vertices = vertices_of_nodes(scene);
    const auto             sums     = impulses();
    std::vector<NodeState> of_rank;
    for (unsigned int n = 0; n < nodes.size(); ++n)
      of_rank.push_back({vertices.at(nodes[n].boundary.dof),
                         memories[n],
                         {{sums[n][0].normal_force,
                           sums[n][0].tangential_force,
                           sums[n][1].normal_force,
                           sums[n][1].tangential_force}}});
    std::vector<NodeState> states;
    for (const auto &part : Utilities::MPI::gather(communicator, of_rank))
      states.insert(states.end(), part.begin(), part.end());
    archive << summed_time << states;
  }



  template <int dim>
  void
  Contact<dim>::load(boost::archive::binary_iarchive &archive)
  {
    std::vector<NodeState> states;
    archive >> summed_time >> states;
    std::map<unsigned int, const NodeState *> state_at;
    for (const NodeState &state : states)
      state_at[state.vertex] = &state;

    impulses_on_particles.clear();
    const auto vertices = vertices_of_nodes(scene);
    for (unsigned int n = 0; n < nodes.size(); ++n)
      {
        const NodeState &state =
          *state_at.at(vertices.at(nodes[n].boundary.dof));
        memories[n] = state.friction;
        for (const unsigned int s : {0u, 1u})
          {
            nodes[n].impulse[s].normal_force     = state.impulses[2 * s];
            nodes[n].impulse[s].tangential_force = state.impulses[2 * s + 1];
          }
      }
  }



#define INSTANTIATE(dim) template class Contact<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
