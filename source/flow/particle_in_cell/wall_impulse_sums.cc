#include <deal.II/base/mpi.h>

#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/in_space.h>
#include <sandglass/flow/particle_in_cell/wall_impulse_sums.h>
#include <sandglass/walls/face_geometry.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/utility.hpp>

namespace Sandglass
{
  template <int dim>
  WallImpulseSums<dim>::WallImpulseSums(
    const Scene<dim>                     &scene,
    const std::vector<BoundaryNode<dim>> &nodes)
    : at_nodes(nodes.size())
    , scene(scene)
    , nodes(nodes)
  {
    find_places();
  }



  template <int dim>
  void
  WallImpulseSums<dim>::find_places()
  {
    std::vector<unsigned int> node_at(scene.triangulation.n_vertices(),
                                      numbers::invalid_unsigned_int);
    for (unsigned int n = 0; n < nodes.size(); ++n)
      node_at[nodes[n].vertex] = n;

    for (const auto &cell : scene.triangulation.active_cell_iterators())
      for (const unsigned int face : cell->face_indices())
        {
          if (!cell->at_boundary(face))
            continue;
          const WallId wall =
            boundary_part(scene.walls, cell->face(face)->boundary_id()).wall;
          if (wall == no_wall)
            continue;
          const Tensor<1, dim> normal = outward_normal(cell, face);
          auto &of_face = places[{cell->active_cell_index(), face}];
          for (const unsigned int v : cell->vertex_indices())
            {
              const unsigned int n = node_at[cell->vertex_index(v)];
              if (n == numbers::invalid_unsigned_int)
                continue;
              // The wall's share of the support that faces most as the face.
              double nearest = -1.;
              for (unsigned int s = 0; s < nodes[n].supports.size(); ++s)
                {
                  const Support<dim> &support = nodes[n].supports[s];
                  for (unsigned int w = 0; w < support.walls.size(); ++w)
                    if (support.walls[w].wall == wall &&
                        support.normal * normal > nearest)
                      {
                        nearest    = support.normal * normal;
                        of_face[v] = {n, s, w};
                      }
                }
            }
        }
  }



  template <int dim>
  std::vector<WallRecord>
  WallImpulseSums<dim>::records() const
  {
    std::vector<NodeSums> sums = at_nodes;
    for (const FaceSumsMap &of_rank :
         Utilities::MPI::all_gather(scene.communicator, on_particles))
      for (const auto &[face, impulses] : of_rank)
        {
          const auto &of_face = places.at(face);
          for (unsigned int v = 0; v < impulses.size(); ++v)
            if (of_face[v].node != numbers::invalid_unsigned_int)
              sums[of_face[v].node][of_face[v].support][of_face[v].wall] +=
                impulses[v];
        }

    std::vector<WallRecord> result;
    for (unsigned int n = 0; n < nodes.size(); ++n)
      for (unsigned int s = 0; s < nodes[n].supports.size(); ++s)
        {
          const Support<dim> &support = nodes[n].supports[s];
          for (unsigned int w = 0; w < support.walls.size(); ++w)
            result.push_back({support.walls[w].wall,
                              nodes[n].vertex,
                              in_space(nodes[n].position),
                              in_space(support.normal),
                              support.walls[w].area,
                              in_space(sums[n][s][w])});
        }
    return result;
  }



  template <int dim>
  Tensor<1, dim>
  WallImpulseSums<dim>::axis_impulse() const
  {
    Tensor<1, dim> sum;
    for (unsigned int n = 0; n < nodes.size(); ++n)
      for (unsigned int s = 0; s < nodes[n].supports.size(); ++s)
        if (nodes[n].supports[s].is_axis)
          sum += at_nodes[n][s][0];
    return sum;
  }



#define INSTANTIATE(dim) template class WallImpulseSums<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
