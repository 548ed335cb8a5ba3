#ifndef sandglass_flow_particle_in_cell_stage_view_templates_h
#define sandglass_flow_particle_in_cell_stage_view_templates_h

#include <sandglass/flow/in_space.h>
#include <sandglass/flow/particle_in_cell/particle_stage.h>

namespace Sandglass
{
  template <typename Layout>
  void
  ParticleStage<Layout>::for_each_particle(
    const std::function<void(const ParticleRecord &)> &function) const
  {
    const Blocks &blocks = cloud.blocks();
    blocks.for_each([&](const ParticleSlot &slot) {
      const Block   &block = blocks[slot.block];
      const auto     state = load_state(block, slot.lane);
      ParticleRecord record;
      record.id       = blocks.id(slot);
      record.location = in_space(block.point(Block::location, slot.lane));
      record.initial_location = in_space(initial_position(record.id));
      record.velocity         = in_space(static_cast<const Tensor<1, dim> &>(
        block.point(Block::velocity, slot.lane)));
      record.stress.fill(0.);
      std::copy(state.stress.begin(),
                state.stress.end(),
                record.stress.begin());
      record.mass      = state.mass;
      record.density   = state.density;
      record.law_state = state.law_state.data();
      function(record);
    });
  }



  template <typename Layout>
  GridRecords
  ParticleStage<Layout>::grid() const
  {
    constexpr std::int32_t unknown = -1;

    // What each rank has summed at nodes that others own is gone.
    NodalSumField<dim> sums = fields.sums;
    sums.update_ghosts();

    GridRecords result;
    result.nodes_per_cell = scene.mesh.vertices_per_cell();
    std::vector<std::int32_t> numbers(scene.nodes->locally_owned_size() +
                                        scene.nodes->n_ghost_indices(),
                                      unknown);
    for (const auto &cell : scene.dof_handler.active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        for (unsigned int n = 0; n < result.nodes_per_cell; ++n)
          {
            const unsigned int vertex =
              vertex_in_vtk_order<dim>(scene.mesh.cell_type, n);
            const unsigned int node =
              scene.nodes->global_to_local(cell->vertex_dof_index(vertex, 0));
            if (numbers[node] == unknown)
              {
                numbers[node] = result.nodes.size();
                Tensor<1, 3> velocity;
                for (unsigned int d = 0; d < dim; ++d)
                  velocity[d] = fields.mapped_velocity.at(node)[d];
                result.nodes.push_back({in_space(cell->vertex(vertex)),
                                        sums.at(node)[NodalSum<dim>::mass],
                                        velocity});
              }
            result.nodes_of_cells.push_back(numbers[node]);
          }
        std::int64_t n_in_cell = 0;
        cloud.blocks().for_each_block_in_cell(cell->active_cell_index(),
                                              [&](const unsigned int block) {
                                                n_in_cell +=
                                                  cloud.blocks().n_lanes(block);
                                              });
        result.cells.push_back({n_in_cell, cell->subdomain_id()});
      }
    return result;
  }



  template <typename Layout>
  std::vector<double>
  ParticleStage<Layout>::cell_work() const
  {
    // How many edges a line of unit length crosses on average in a mesh of
    // cells of unit area: a cell's perimeter over pi times its area.
    constexpr double crossings = 1.4;

    const Blocks       &blocks = cloud.blocks();
    std::vector<double> work(blocks.n_cells(), 0.);
    for (const auto &cell : cloud.owned_cells())
      {
        const unsigned int index  = cell->active_cell_index();
        unsigned int       n      = 0;
        double             speeds = 0.;
        blocks.for_each_in_cell(index, [&](const ParticleSlot &slot) {
          ++n;
          speeds += blocks[slot.block].point(Block::velocity, slot.lane).norm();
        });
        if (n == 0)
          continue;
        const double n_leaving =
          std::min<double>(n,
                           speeds * time.time_step * crossings /
                             std::pow(cell->measure(), 1. / dim));
        work[index] = Sandglass::cell_work(n, n_leaving);
      }
    return work;
  }
} // namespace Sandglass

#endif
