// Friction that contact takes over from the state at rest.

#include <deal.II/base/mpi.h>

#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/particle_in_cell/contact.h>

#include <map>

namespace Sandglass
{
  namespace
  {
    /// Which support a force of the state at rest has come from: the wall's, or
    /// one with its direction. None if a wall has gone with its direction.
    template <int dim>
    int
    find_support(const BoundaryNode<dim> &node, const WallForce<dim> &force)
    {
      constexpr double same_direction = 1. - 1e-8;

      int    found   = -1;
      double nearest = -1.;
      for (unsigned int s = 0; s < node.supports.size(); ++s)
        {
          const Support<dim> &support = node.supports[s];
          const double        cosine  = support.normal * force.normal;
          bool                matches = cosine > same_direction;
          for (const WallShare &share : support.walls)
            matches = matches || share.wall == force.wall;
          if (matches && !support.is_axis && cosine > nearest)
            {
              found   = s;
              nearest = cosine;
            }
        }
      return found;
    }
  } // namespace



  template <int dim>
  void
  Contact<dim>::start_from(const std::vector<WallForce<dim>> &wall_forces)
  {
    // The static stage divides nodes between the ranks in its own way.
    std::multimap<unsigned int, WallForce<dim>> forces_at;
    for (const auto &of_rank :
         Utilities::MPI::all_gather(scene.communicator, wall_forces))
      for (const WallForce<dim> &force : of_rank)
        forces_at.emplace(force.vertex, force);

    for (unsigned int n = 0; n < nodes.size(); ++n)
      {
        memories[n] = {};
        if (is_corner(n))
          continue;
        const auto [begin, end] = forces_at.equal_range(nodes[n].vertex);
        for (auto entry = begin; entry != end; ++entry)
          {
            const int s = find_support(nodes[n], entry->second);
            if (s >= 0)
              memories[n][s].force +=
                along_support(nodes[n], s, entry->second.force);
          }
      }
  }



#define INSTANTIATE(dim) \
  template void Contact<dim>::start_from(const std::vector<WallForce<dim>> &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
