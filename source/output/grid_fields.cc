#include <sandglass/output/fields.h>

#include <array>

namespace Sandglass
{
  namespace
  {
    using CellIterator = DoFHandler<dim>::active_cell_iterator;

    /// deal.II numbers a quadrilateral's vertices line by line.
    constexpr std::array<unsigned int, 4> counterclockwise = {{0, 1, 3, 2}};



    /// Number the nodes of this rank's cells in the order in which the cells
    /// meet them, and collect what is known at them.
    class NodeFields
    {
    public:
      explicit NodeFields(ParticleStage &stage)
        : stage(stage)
        , numbers(stage.scene.nodes->locally_owned_size() +
                    stage.scene.nodes->n_ghost_indices(),
                  unknown)
      {
        // What each rank has summed at nodes that others own is gone.
        stage.fields.sums.update_ghosts();
      }

      std::int32_t
      number(const CellIterator &cell, const unsigned int vertex)
      {
        const unsigned int node =
          stage.scene.nodes->global_to_local(cell->vertex_dof_index(vertex, 0));
        if (numbers[node] == unknown)
          {
            numbers[node] = mass.size();
            add(node, cell->vertex(vertex));
          }
        return numbers[node];
      }

      std::vector<double> points;
      std::vector<float>  mass, velocity;

    private:
      void
      add(const unsigned int node, const Point<dim> &position)
      {
        const double *v = stage.fields.mapped_velocity.at(node);
        points.insert(points.end(), {position[0], position[1], 0.});
        mass.push_back(stage.fields.sums.at(node)[NodalSum::mass]);
        for (const double component : {v[0], v[1], 0.})
          velocity.push_back(component);
      }

      static constexpr std::int32_t unknown = -1;

      ParticleStage            &stage;
      std::vector<std::int32_t> numbers;
    };
  } // namespace



  VtuPiece
  grid_fields(ParticleStage &stage)
  {
    const bool is_triangle = stage.scene.mesh.cell_type == CellType::triangle;
    NodeFields nodes(stage);
    VtuPiece   piece;
    std::vector<std::int64_t> n_particles, subdomain;

    const ParticleBlocks &blocks = stage.cloud.blocks();
    piece.points_per_cell        = is_triangle ? 3 : 4;
    for (const auto &cell : stage.scene.dof_handler.active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        for (unsigned int v = 0; v < piece.points_per_cell; ++v)
          piece.cells.push_back(
            nodes.number(cell, is_triangle ? v : counterclockwise[v]));
        std::int64_t n = 0;
        blocks.for_each_block_in_cell(cell->active_cell_index(),
                                      [&](const unsigned int block) {
                                        n += blocks.n_lanes(block);
                                      });
        n_particles.push_back(n);
        subdomain.push_back(cell->subdomain_id());
      }

    piece.points       = std::move(nodes.points);
    piece.point_fields = {{"mass", 1, std::move(nodes.mass), {}},
                          {"velocity", 3, std::move(nodes.velocity), {}}};
    piece.cell_fields = {{"number of particles", 1, std::move(n_particles), {}},
                         {"subdomain", 1, std::move(subdomain), {}}};
    return piece;
  }
} // namespace Sandglass
