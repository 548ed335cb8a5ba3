#include <sandglass/base/exceptions.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/updated_lagrangian/match_vertices.h>
#include <sandglass/flow/updated_lagrangian/static_stage.h>

#include <algorithm>
#include <sstream>

namespace Sandglass
{
  namespace
  {
    std::string
    failure_message(const double load_share, const RestResult &result)
    {
      std::ostringstream message;
      message
        << "The static stage found no state at rest: at a load of "
        << load_share << " of the weight the out-of-balance force is "
        << result.residual << " of the weight after "
        << result.n_newton_iterations << " Newton iterations and "
        << result.n_relaxation_steps
        << " relaxation steps, with the smallest load step. Try, in "
           "section 'Static stage', a larger 'Maximum relaxation steps' "
           "or more 'Load steps'; or another 'Element size', a larger 'Poisson ratio' "
           "or a smaller 'Internal friction angle'.";
      return message.str();
    }
  } // namespace



  namespace
  {
    /// Of a load step, for laws whose stiffness vanishes with stress: they are
    /// hard to load at first.
    constexpr double first_share = 0.01;
  } // namespace



  template <int dim>
  StaticStage<dim>::StaticStage(const Scene<dim>         &scene,
                                const MaterialParameters &material_parameters,
                                const WallParameters     &wall_parameters,
                                const StaticStageParameters &parameters,
                                ConditionalOStream          &log,
                                const unsigned int           element_order)
    : scene(scene)
    , material(material_parameters)
    , parameters(parameters)
    , log(log)
    , filled_grid(scene, element_order)
    , equilibrium(make_equilibrium(filled_grid,
                                   scene.formulation,
                                   material_parameters,
                                   scene.gravity))
    , contact(filled_grid,
              scene,
              wall_parameters,
              equilibrium->weight(),
              equilibrium->confined_modulus())
    , solver(filled_grid, *equilibrium, contact, parameters)
    , has_weight(equilibrium->weight().l2_norm() > 0.)
    , largest_load_step(1. / parameters.n_load_steps)
    , load_step((equilibrium->has_constant_stiffness() ? 1. : first_share) *
                largest_load_step)
    , displacement(filled_grid.make_vector())
    , predictor(displacement)
  {
    effort.n_unknowns = filled_grid.dof_handler.n_dofs();
    effort.is_direct  = solver.is_direct();
  }



  template <int dim>
  bool
  StaticStage<dim>::is_finished() const
  {
    return !has_weight || (is_at_rest && is_fully_loaded());
  }



  template <int dim>
  StaticState<dim>
  StaticStage<dim>::run(
    const std::function<void(const double)> &after_load_step)
  {
    if (!is_finished())
      log << "Static stage: " << effort.n_unknowns << " unknowns, "
          << (effort.is_direct ? "direct solver" : "multigrid") << std::endl;
    while (!is_finished())
      {
        step();
        if (after_load_step)
          after_load_step(load_share);
      }
    return make_state();
  }



  template <int dim>
  void
  StaticStage<dim>::step()
  {
    while (true)
      {
        const double step =
          is_fully_loaded() ? 0. : std::min(load_step, 1. - load_share);
        const double     goal      = load_share + step;
        Vector           increment = predictor.predict(step);
        const RestResult result    = solve(goal, increment);

        count(goal, result);
        if (result.is_acceptable)
          {
            accept(increment);
            load_share = goal;
            if (step > 0.)
              predictor.add(step, increment);
            else
              ++n_repetitions;
            end_load_step(result);
            load_step = std::min(2. * load_step, largest_load_step);
            ++time.step;
            return;
          }
        load_step = step / 2.;
        if (load_step < parameters.smallest_load_step)
          throw RunError(failure_message(goal, result));
      }
  }



  template <int dim>
  RestResult
  StaticStage<dim>::solve(const double goal, Vector &increment)
  {
    if (!settled_weight)
      return solver.solve(displacement, goal, increment);
    // What was at rest before has its whole weight all the time.
    Vector weight = *settled_weight;
    weight.zero_out_ghost_values();
    weight.sadd(1. - goal, goal, *whole_weight);
    weight.update_ghost_values();
    equilibrium->set_weight(weight);
    return solver.solve(displacement, 1., increment);
  }



  template <int dim>
  void
  StaticStage<dim>::end_load_step(const RestResult &result)
  {
    // Nearly all that needs repetitions is at rest after one or two.
    constexpr unsigned int most_repetitions = 20;

    is_at_rest = result.has_converged || n_repetitions == most_repetitions;
    if (is_at_rest && !result.has_converged)
      log << "Warning: The state at rest is not quite one: the out-of-balance "
             "force is "
          << result.residual << " of the weight." << std::endl;
  }



  template <int dim>
  void
  StaticStage<dim>::count(const double load_share, const RestResult &result)
  {
    effort.n_newton_iterations += result.n_newton_iterations;
    effort.n_linear_iterations += result.n_linear_iterations;
    effort.n_relaxation_steps += result.n_relaxation_steps;
    log << "Load step to " << load_share
        << " of the weight: " << result.n_newton_iterations << " iterations ("
        << result.n_linear_iterations << " linear), ";
    if (result.n_relaxation_steps > 0)
      log << result.n_relaxation_steps << " steps of dynamic relaxation, ";
    log << "residual " << result.residual
        << (!result.is_acceptable ? ", given up" :
            !result.has_converged ? ", not at rest" :
            result.method == RestResult::Method::relaxation ?
                                    ", by relaxation alone" :
                                    "")
        << std::endl;
  }



  template <int dim>
  void
  StaticStage<dim>::accept(Vector &increment)
  {
    displacement.zero_out_ghost_values();
    displacement.add(1., increment);
    displacement.update_ghost_values();
    equilibrium->start_step();
    contact.commit();
  }



  template <int dim>
  StaticState<dim>
  StaticStage<dim>::make_state() const
  {
    StaticState<dim> state;
    state.element_order = filled_grid.finite_element.degree;
    state.cells.resize(scene.triangulation.n_active_cells());
    state.wall_forces = contact.wall_forces();
    state.effort      = effort;

    std::vector<types::global_dof_index> dofs(
      filled_grid.finite_element.n_dofs_per_cell());
    auto scene_cell = scene.triangulation.begin_active();
    for (const auto &cell : filled_grid.dof_handler.active_cell_iterators())
      {
        // both run through the cells in the order of the Scene's mesh
        const unsigned int index =
          filled_grid.scene_cells[cell->active_cell_index()];
        while (scene_cell->active_cell_index() < index)
          ++scene_cell;
        if (!cell->is_locally_owned())
          continue;
        Assert(scene_cell->is_locally_owned(), ExcInternalError());

        const auto match  = match_vertices(*scene_cell, *cell);
        auto      &result = state.cells[index];
        for (const unsigned int v : cell->vertex_indices())
          for (unsigned int d = 0; d < dim; ++d)
            result.displacement[v][d] =
              displacement[cell->vertex_dof_index(match[v], d)];
        if (state.element_order == 2)
          {
            // Triangles have the same orientation in all triangulations.
            cell->get_dof_indices(dofs);
            for (unsigned int i = cell->n_vertices(); i < dofs.size() / dim;
                 ++i)
              for (unsigned int d = 0; d < dim; ++d)
                result.displacement[i][d] = displacement[dofs[dim * i + d]];
          }
        // a quadrilateral's quadrature point q lies next to its vertex q
        for (unsigned int q = 0; q < filled_grid.quadrature.size(); ++q)
          {
            const auto point = equilibrium->point_state(
              filled_grid.point_index(*cell, match[q]));
            result.stress[q]       = point.stress;
            result.volume_ratio[q] = point.volume_ratio;
            result.law_state[q]    = point.law_state;
          }
      }
    return state;
  }



#define INSTANTIATE(dim) template class StaticStage<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
