// What others see of the static stage, and its checkpoints.

#include <deal.II/base/mpi.h>

#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/in_space.h>
#include <sandglass/flow/updated_lagrangian/static_stage.h>
#include <sandglass/flow/updated_lagrangian/vertex_values.h>
#include <sandglass/material/chosen_law.h>

#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace Sandglass
{
  template <int dim>
  double
  StaticStage<dim>::nodal_mass(const CellIterator &cell,
                               const unsigned int  vertex) const
  {
    if (!has_weight)
      return 0.;
    Tensor<1, dim> weight;
    for (unsigned int d = 0; d < dim; ++d)
      weight[d] = equilibrium->weight()[cell->vertex_dof_index(vertex, d)];
    return weight * scene.gravity / scene.gravity.norm_square();
  }



  template <int dim>
  FlowTotals
  StaticStage<dim>::totals() const
  {
    std::set<types::global_dof_index> nodes;
    double                            mass = 0.;
    for (const auto &local_cell : filled_grid.local_cells)
      for (const unsigned int v : local_cell.cell->vertex_indices())
        {
          const auto dof = local_cell.cell->vertex_dof_index(v, 0);
          if (filled_grid.owned_dofs.is_element(dof) &&
              nodes.insert(dof).second)
            mass += nodal_mass(local_cell.cell, v);
        }
    FlowTotals totals;
    totals.mass_in_silo = Utilities::MPI::sum(mass, scene.communicator);
    return totals;
  }



  template <int dim>
  double
  StaticStage<dim>::critical_time_step(const bool) const
  {
    return std::numeric_limits<double>::infinity();
  }



  template <int dim>
  std::vector<StateVariable>
  StaticStage<dim>::state_variables() const
  {
    return state_variables_of_law(material);
  }



  template <int dim>
  GridRecords
  StaticStage<dim>::grid() const
  {
    GridRecords result;
    result.nodes_per_cell = scene.mesh.vertices_per_cell();
    std::map<unsigned int, std::int32_t> numbers; // of vertices
    for (const auto &local_cell : filled_grid.local_cells)
      {
        const auto &cell = local_cell.cell;
        if (!cell->is_locally_owned())
          continue;
        for (unsigned int n = 0; n < result.nodes_per_cell; ++n)
          {
            const unsigned int v =
              vertex_in_vtk_order<dim>(scene.mesh.cell_type, n);
            const auto [number, is_new] =
              numbers.emplace(cell->vertex_index(v), result.nodes.size());
            if (is_new)
              result.nodes.push_back(
                {in_space(cell->vertex(v)), nodal_mass(cell, v), {}});
            result.nodes_of_cells.push_back(number->second);
          }
        result.cells.push_back({0, cell->subdomain_id()});
      }
    return result;
  }



  template <int dim>
  void
  StaticStage<dim>::save(boost::archive::binary_oarchive &archive) const
  {
    const auto values = values_at_vertices(filled_grid, displacement);
    const auto last   = values_at_vertices(filled_grid, predictor.last);
    const auto before_last =
      values_at_vertices(filled_grid, predictor.before_last);
    archive << time << load_share << is_at_rest << n_repetitions << load_step
            << values << last << predictor.last_step << before_last
            << predictor.before_last_step;
    archive << effort.n_newton_iterations << effort.n_linear_iterations
            << effort.n_relaxation_steps;
    equilibrium->save(archive);
    contact.save(archive);
  }



  template <int dim>
  void
  StaticStage<dim>::load(boost::archive::binary_iarchive &archive)
  {
    std::vector<double> values, last, before_last;
    archive >> time >> load_share >> is_at_rest >> n_repetitions >> load_step >>
      values >> last >> predictor.last_step >> before_last >>
      predictor.before_last_step;
    archive >> effort.n_newton_iterations >> effort.n_linear_iterations >>
      effort.n_relaxation_steps;
    displacement          = vector_of_values(filled_grid, values);
    predictor.last        = vector_of_values(filled_grid, last);
    predictor.before_last = vector_of_values(filled_grid, before_last);
    equilibrium->load(archive);
    contact.load(archive);
  }



  template <int dim>
  WallArea
  StaticStage<dim>::wall_area() const
  {
    WallArea area{0., 0.}; // at rest nothing slides
    for (const WallForce<dim> &force : contact.wall_forces())
      if (force.normal_force() > 0.)
        area.touching += force.area;
    return area;
  }



  template <int dim>
  WallRecords
  StaticStage<dim>::wall_records() const
  {
    WallRecords result;
    result.time             = 1.;
    const bool is_quadratic = filled_grid.finite_element.degree == 2;
    for (const WallForce<dim> &force : contact.wall_forces())
      {
        const WallRecord record{force.wall,
                                force.vertex,
                                in_space(scene.mesh.vertices[force.vertex]),
                                in_space(force.normal),
                                force.area,
                                in_space(result.time * force.force)};
        const auto       known =
          !is_quadratic ? result.records.end() :
                                std::find_if(result.records.begin(),
                                       result.records.end(),
                                       [&record](const WallRecord &other) {
                                         return other.wall == record.wall &&
                                                other.vertex == record.vertex &&
                                                other.normal == record.normal;
                                       });
        if (known == result.records.end())
          result.records.push_back(record);
        else
          {
            known->area += record.area;
            known->impulse += record.impulse;
          }
      }
    return result;
  }



#define INSTANTIATE(dim) template class StaticStage<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
