// How the static stage places a layer on others that are at rest.

#include <deal.II/base/mpi.h>

#include <sandglass/base/gather.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/updated_lagrangian/match_vertices.h>
#include <sandglass/flow/updated_lagrangian/static_stage.h>
#include <sandglass/flow/updated_lagrangian/vertex_values.h>

#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <sstream>
#include <utility>

namespace Sandglass
{
  namespace
  {
    /// Values at the vertices of a filled grid as those at the scene's.
    template <int dim>
    std::vector<double>
    to_scene(const FilledGrid<dim>     &grid,
             const std::vector<double> &values,
             const std::size_t          n_vertices)
    {
      std::vector<double> result(dim * n_vertices, 0.);
      for (unsigned int v = 0; v < grid.scene_vertices.size(); ++v)
        for (unsigned int d = 0; d < dim; ++d)
          result[dim * grid.scene_vertices[v] + d] = values[dim * v + d];
      return result;
    }



    template <int dim>
    std::vector<double>
    from_scene(const FilledGrid<dim> &grid, const std::vector<double> &values)
    {
      std::vector<double> result(dim * grid.scene_vertices.size(), 0.);
      for (unsigned int v = 0; v < grid.scene_vertices.size(); ++v)
        for (unsigned int d = 0; d < dim; ++d)
          result[dim * v + d] = values[dim * grid.scene_vertices[v] + d];
      return result;
    }
  } // namespace



  template <int dim>
  SettledLayers<dim>
  StaticStage<dim>::settled_layers() const
  {
    using Point = typename SettledLayers<dim>::Point;

    const std::size_t  n_vertices = scene.mesh.vertices.size();
    SettledLayers<dim> result;
    result.effort = effort;
    result.displacement =
      to_scene(filled_grid,
               values_at_vertices(filled_grid, displacement),
               n_vertices);
    result.weight =
      to_scene(filled_grid,
               values_at_vertices(filled_grid,
                                  settled_weight ? *whole_weight :
                                                   equilibrium->weight()),
               n_vertices);

    std::vector<std::pair<unsigned int, std::vector<Point>>> of_rank;
    const StaticState<dim> state = make_state();
    for (const auto &cell : filled_grid.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const unsigned int index =
            filled_grid.scene_cells[cell->active_cell_index()];
          const auto        &of_cell = state.cells[index];
          std::vector<Point> points;
          for (unsigned int q = 0; q < filled_grid.quadrature.size(); ++q)
            {
              const double *stress = of_cell.stress[q].data();
              points.push_back({{stress, stress + of_cell.stress[q].size()},
                                of_cell.volume_ratio[q],
                                of_cell.law_state[q]});
            }
          of_rank.emplace_back(index, points);
        }
    result.points.resize(scene.mesh.cells.size());
    for (const auto &of_one :
         Utilities::MPI::all_gather(scene.communicator, of_rank))
      for (const auto &[index, points] : of_one)
        result.points[index] = points;

    std::ostringstream stream;
    {
      boost::archive::binary_oarchive archive(stream);
      contact.save(archive);
    }
    result.contact =
      Utilities::MPI::broadcast(scene.communicator, stream.str());
    return result;
  }



  template <int dim>
  void
  StaticStage<dim>::place_on(const SettledLayers<dim> &layers)
  {
    displacement =
      vector_of_values(filled_grid,
                       from_scene(filled_grid, layers.displacement));
    whole_weight   = std::make_unique<Vector>(equilibrium->weight());
    settled_weight = std::make_unique<Vector>(
      vector_of_values(filled_grid, from_scene(filled_grid, layers.weight)));
    equilibrium->move_reference(displacement);

    std::vector<typename Triangulation<dim>::active_cell_iterator> scene_cells;
    for (const auto &cell : scene.triangulation.active_cell_iterators())
      scene_cells.push_back(cell);
    for (const auto &local_cell : filled_grid.local_cells)
      {
        const auto        &cell = local_cell.cell;
        const unsigned int index =
          filled_grid.scene_cells[cell->active_cell_index()];
        const auto &points = layers.points[index];
        if (points.empty())
          continue;
        const auto match = match_vertices<dim>(*scene_cells[index], *cell);
        for (unsigned int q = 0; q < points.size(); ++q)
          {
            typename Equilibrium<dim>::PointState state;
            std::copy(points[q].stress.begin(),
                      points[q].stress.end(),
                      state.stress.data());
            state.volume_ratio = points[q].volume_ratio;
            state.law_state    = points[q].law_state;
            equilibrium->set_point_state(filled_grid.point_index(*cell,
                                                                 match[q]),
                                         state);
          }
      }

    std::istringstream              stream(layers.contact);
    boost::archive::binary_iarchive archive(stream);
    contact.load(archive);

    // A layer is a small part of the weight.
    largest_load_step = 1.;
    load_step         = 1.;
    effort.n_newton_iterations += layers.effort.n_newton_iterations;
    effort.n_linear_iterations += layers.effort.n_linear_iterations;
    effort.n_relaxation_steps += layers.effort.n_relaxation_steps;
  }



#define INSTANTIATE(dim)                                                \
  template SettledLayers<dim> StaticStage<dim>::settled_layers() const; \
  template void StaticStage<dim>::place_on(const SettledLayers<dim> &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
