#include <deal.II/numerics/data_out.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/choices.h>
#include <sandglass/flow/updated_lagrangian/static_stage.h>

#include <algorithm>
#include <sstream>

namespace Sandglass
{
  namespace
  {
    std::string
    failure_message(const double load_share, const NewtonResult &result)
    {
      std::ostringstream message;
      message << "The static stage found no state at rest: at a load of "
              << load_share << " of the weight the out-of-balance force is "
              << result.residual << " of the weight after "
              << result.n_iterations
              << " iterations, with the smallest load step. Try, in section "
                 "'Static stage', a larger 'Maximum iterations' or more 'Load "
                 "steps'; or another 'Element size', a larger 'Poisson ratio' "
                 "or a smaller 'Internal friction angle'.";
      return message.str();
    }



    /**
     * Guesses the displacement increment of the next load step from the last
     * two. Without cohesion, displacement grows nearly in proportion to the
     * weight, and how fast it grows changes nearly linearly.
     */
    class Predictor
    {
    public:
      explicit Predictor(const DisplacementVector &zero)
        : last(zero)
        , before_last(zero)
      {}

      void
      add(const double step, const DisplacementVector &increment)
      {
        std::swap(last, before_last);
        before_last_step = last_step;
        last             = increment;
        last_step        = step;
      }

      /// Zero as long as no step is known.
      DisplacementVector
      predict(const double step) const
      {
        DisplacementVector increment = last;
        if (before_last_step > 0.)
          {
            // between the middles of steps
            const double distance = (step + last_step) / 2.;
            const double weight =
              distance / ((last_step + before_last_step) / 2.);
            increment *= (1. + weight) * step / last_step;
            increment.add(-weight * step / before_last_step, before_last);
          }
        else if (last_step > 0.)
          increment *= step / last_step;
        increment.update_ghost_values();
        return increment;
      }

    private:
      DisplacementVector last, before_last;
      double             last_step = 0., before_last_step = 0.;
    };



    /**
     * For each vertex of `cell` the number that it has in `same_cell` of
     * another triangulation. deal.II orients quadrilaterals by their
     * neighbours, so that it need not be the same.
     */
    template <int dim>
    std::array<unsigned int, 1u << dim>
    match_vertices(const CellAccessor<dim> &cell,
                   const CellAccessor<dim> &same_cell)
    {
      std::array<unsigned int, 1u << dim> result{};
      for (const unsigned int v : cell.vertex_indices())
        {
          unsigned int w = 0;
          while (w < cell.n_vertices() && same_cell.vertex(w) != cell.vertex(v))
            ++w;
          Assert(w < cell.n_vertices(), ExcInternalError());
          result[v] = w;
        }
      return result;
    }
  } // namespace



  template <int dim>
  StaticStage<dim>::StaticStage(const Scene<dim>         &scene,
                                const MaterialParameters &material_parameters,
                                const WallParameters     &wall_parameters,
                                const StaticStageParameters &parameters,
                                ConditionalOStream          &log)
    : scene(scene)
    , parameters(parameters)
    , log(log)
    , grid(scene)
    , equilibrium(make_equilibrium(grid,
                                   scene.formulation,
                                   material_parameters,
                                   scene.gravity))
    , contact(grid,
              scene,
              wall_parameters,
              equilibrium->weight(),
              equilibrium->confined_modulus())
    , solver(grid, *equilibrium, contact, parameters)
    , displacement(grid.make_vector())
  {
    effort.n_unknowns = grid.dof_handler.n_dofs();
    effort.is_direct  = solver.is_direct();
  }



  template <int dim>
  StaticState<dim>
  StaticStage<dim>::run()
  {
    if (equilibrium->weight().l2_norm() == 0.)
      return make_state();

    log << "Static stage: " << effort.n_unknowns << " unknowns, "
        << (effort.is_direct ? "direct solver" : "multigrid") << std::endl;
    const double largest_step = 1. / parameters.n_load_steps;
    double       load = 0., step = largest_step;
    Predictor    predictor(displacement);
    while (load < 1. - 1e-12)
      {
        const double       this_step = std::min(step, 1. - load);
        Vector             increment = predictor.predict(this_step);
        const NewtonResult result =
          solver.solve(displacement, load + this_step, increment);

        count(load + this_step, result);
        if (result.has_converged)
          {
            accept(increment);
            load += this_step;
            predictor.add(this_step, increment);
            step = std::min(2. * step, largest_step);
          }
        else
          {
            contact.restore();
            step = this_step / 2.;
            if (step < parameters.smallest_load_step)
              throw RunError(failure_message(load + this_step, result));
          }
      }
    return make_state();
  }



  template <int dim>
  void
  StaticStage<dim>::count(const double load_share, const NewtonResult &result)
  {
    effort.n_newton_iterations += result.n_iterations;
    effort.n_linear_iterations += result.n_linear_iterations;
    log << "Load step to " << load_share
        << " of the weight: " << result.n_iterations << " iterations ("
        << result.n_linear_iterations << " linear), residual "
        << result.residual << (result.has_converged ? "" : ", not converged")
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
    state.cells.resize(scene.triangulation.n_active_cells());
    state.wall_forces = contact.wall_forces();
    state.effort      = effort;

    auto scene_cell = scene.triangulation.begin_active();
    for (const auto &cell : grid.dof_handler.active_cell_iterators())
      {
        // both run through the cells in the order of the Scene's mesh
        const unsigned int index = grid.scene_cells[cell->active_cell_index()];
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
        // a quadrilateral's quadrature point q lies next to its vertex q
        for (unsigned int q = 0; q < grid.quadrature.size(); ++q)
          {
            const auto point =
              equilibrium->point_state(grid.point_index(*cell, match[q]));
            result.stress[q]       = point.stress;
            result.volume_ratio[q] = point.volume_ratio;
            result.law_state[q]    = point.law_state;
          }
      }
    return state;
  }



  template <int dim>
  void
  StaticStage<dim>::write_vtu(const std::string &directory) const
  {
    const std::array<std::string, 5> names = {
      {"stress_xx", "stress_yy", "stress_zz", "stress_xy", "volume_ratio"}};
    std::array<dealii::Vector<double>, names.size()> means;
    means.fill(dealii::Vector<double>(grid.triangulation.n_active_cells()));
    const unsigned int n_points = grid.quadrature.size();
    for (const auto &cell : grid.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        for (unsigned int q = 0; q < n_points; ++q)
          {
            const unsigned int i = cell->active_cell_index();
            const auto         point =
              equilibrium->point_state(grid.point_index(*cell, q));
            for (unsigned int c = 0; c < 4; ++c)
              means[c][i] += point.stress[c] / n_points;
            means[4][i] += point.volume_ratio / n_points;
          }

    DataOut<dim> data_out;
    // The numbers' last digits are noise, on which more effort gains little.
    DataOutBase::VtkFlags flags;
    flags.compression_level = DataOutBase::VtkFlags::best_speed;
    data_out.set_flags(flags);
    data_out.attach_dof_handler(grid.dof_handler);
    data_out.add_data_vector(
      displacement,
      std::vector<std::string>(dim, "displacement"),
      DataOut<dim>::type_dof_data,
      std::vector<DataComponentInterpretation::DataComponentInterpretation>(
        dim, DataComponentInterpretation::component_is_part_of_vector));
    for (unsigned int c = 0; c < means.size(); ++c)
      data_out.add_data_vector(means[c],
                               names[c],
                               DataOut<dim>::type_cell_data);
    data_out.build_patches(grid.mapping);
    data_out.write_vtu_in_parallel(directory + "/static.vtu",
                                   scene.communicator);
  }



#define INSTANTIATE(dim) template class StaticStage<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
