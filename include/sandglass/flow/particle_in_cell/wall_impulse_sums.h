#ifndef sandglass_flow_particle_in_cell_wall_impulse_sums_h
#define sandglass_flow_particle_in_cell_wall_impulse_sums_h

#include <sandglass/flow/flow_view.h>
#include <sandglass/flow/particle_in_cell/wall_impulse.h>
#include <sandglass/scene/scene.h>
#include <sandglass/walls/boundary_nodes.h>

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace Sandglass
{
  /**
   * What walls and axis have done to the material since the start: impulses at
   * the boundary's nodes, by support and wall, and on single particles, by face
   * of the wall. In N s (plane strain: per metre of depth).
   */
  template <int dim>
  class WallImpulseSums
  {
  public:
    /// Of one node: for each support its walls' impulses, in the support's
    /// order, or the axis' impulse.
    using NodeSums =
      std::array<std::array<Tensor<1, dim>, Support<dim>::most_walls>, dim>;

    /// At the vertices of a boundary face's cell.
    using FaceSums = std::array<Tensor<1, dim>, 1u << dim>;

    /// Index of a cell, and number of a face in it.
    using FaceIndex = std::pair<unsigned int, unsigned int>;

    using FaceSumsMap = std::map<FaceIndex, FaceSums>;

    /// @param nodes  the boundary's nodes that this rank owns.
    WallImpulseSums(const Scene<dim>                     &scene,
                    const std::vector<BoundaryNode<dim>> &nodes);

    void
    clear()
    {
      at_nodes.assign(nodes.size(), NodeSums());
      on_particles.clear();
    }

    /// Add what a support does at node `n` to hold it: walls share it by area.
    void
    add_normal(const unsigned int    n,
               const unsigned int    support,
               const Tensor<1, dim> &impulse)
    {
      const auto &walls = nodes[n].supports[support].walls;
      auto       &sums  = at_nodes[n][support];
      if (walls.size() <= 1)
        sums[0] += impulse;
      else
        for (unsigned int w = 0; w < walls.size(); ++w)
          sums[w] += walls[w].of_normal_force * impulse;
    }

    /// Add what friction does at node `n`.
    void
    add_friction(const unsigned int    n,
                 const unsigned int    support,
                 const Tensor<1, dim> &impulse)
    {
      const auto &walls = nodes[n].supports[support].walls;
      for (unsigned int w = 0; w < walls.size(); ++w)
        at_nodes[n][support][w] += walls[w].of_friction * impulse;
    }

    /// Add what a wall does to a particle. The face's vertices get the shares
    /// that their linear shape functions have at the particle's place.
    void
    add(const WallImpulse<dim> &impulse)
    {
      FaceSums &sums = on_particles[{impulse.cell, impulse.face}];
      for (unsigned int v = 0; v < sums.size(); ++v)
        sums[v] += impulse.shape_values[v] * impulse.impulse;
    }

    /// The walls' records at this rank's nodes, those on particles added.
    /// Collective, since a particle's wall may have a node of another rank.
    std::vector<WallRecord>
    records() const;

    /// What the axis has done at this rank's nodes.
    Tensor<1, dim>
    axis_impulse() const;

    /// For checkpoints: node by node, and on particles.
    std::vector<NodeSums> at_nodes;
    FaceSumsMap           on_particles;

  private:
    /// Where the impulse at one vertex of a wall's face belongs.
    struct Place
    {
      unsigned int node = numbers::invalid_unsigned_int; ///< none of this rank
      unsigned int support = 0, wall = 0; ///< of the node, of the support
    };

    void
    find_places();

    const Scene<dim>                     &scene;
    const std::vector<BoundaryNode<dim>> &nodes;

    /// Of the vertices of the cell of each wall's face.
    std::map<FaceIndex, std::array<Place, 1u << dim>> places;
  };
} // namespace Sandglass

#endif
