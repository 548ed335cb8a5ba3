#include <deal.II/dofs/dof_tools.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/trilinos_solver.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <deal.II/numerics/data_out.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/static_stage/static_stage.h>

#include <cmath>

namespace Sandglass
{
  namespace
  {
    /**
     * How much elastic stiffness Newton's tangent gets: none as long as the
     * exact tangent lowers the residual, more after each failure, less again
     * after success.
     */
    class ElasticShare
    {
    public:
      double
      value() const
      {
        return share;
      }

      bool
      is_full() const
      {
        return share == 1.;
      }

      /// @param factor  that the line search found; 0 is a failure.
      void
      adapt(const double factor)
      {
        if (factor == 0.)
          share = share == 0. ? smallest : std::min(1., share * 4.);
        else if (factor < 0.5)
          share = std::max(share, smallest);
        else
          share = share <= smallest ? 0. : share / 4.;
      }

    private:
      static constexpr double smallest = 1e-2;
      double                  share    = 0.;
    };
  } // namespace



  StaticStage::StaticStage(const Scene                 &scene,
                           const MaterialParameters    &material_parameters,
                           const WallParameters        &wall_parameters,
                           const StaticStageParameters &parameters,
                           ConditionalOStream          &log)
    : scene(scene)
    , parameters(parameters)
    , log(log)
    , material(material_parameters.drucker_prager())
    , grid(scene)
    , equilibrium(grid,
                  scene.formulation,
                  material,
                  material_parameters.density,
                  scene.gravity)
    , contact(grid,
              scene.formulation,
              wall_parameters,
              material.elasticity.confined_modulus())
    , displacement_before(grid.make_vector())
    , displacement(grid.make_vector())
    , increment(grid.make_vector())
    , forces(grid.make_vector())
    , residual(grid.make_vector())
  {
    TrilinosWrappers::SparsityPattern sparsity(grid.owned_dofs,
                                               scene.communicator);
    DoFTools::make_sparsity_pattern(grid.dof_handler,
                                    sparsity,
                                    AffineConstraints<double>(),
                                    true,
                                    grid.triangulation.locally_owned_subdomain());
    sparsity.compress();
    tangent.reinit(sparsity);
  }



  double
  StaticStage::evaluate(const Vector &trial_increment, const double load_share)
  {
    displacement = displacement_before;
    displacement += trial_increment;
    displacement.update_ghost_values();
    equilibrium.evaluate_forces(trial_increment, load_share, forces);
    contact.evaluate(forces, displacement, trial_increment);
    residual = forces;
    contact.replace_residual(residual);
    return residual.l2_norm() / equilibrium.weight().l2_norm();
  }



  void
  StaticStage::move_along(const Vector &step, const double factor, Vector &result)
  {
    result.zero_out_ghost_values();
    increment.zero_out_ghost_values();
    result = increment;
    result.add(-factor, step);
    result.update_ghost_values();
    increment.update_ghost_values();
  }



  double
  StaticStage::search_line(const Vector &step,
                           const double  residual_norm,
                           const double  load_share)
  {
    Vector trial       = grid.make_vector();
    double best_factor = 0., best_norm = residual_norm;
    for (double factor = 1.; factor >= 0.125; factor /= 2.)
      {
        move_along(step, factor, trial);
        const double norm = evaluate(trial, load_share);
        if (norm < best_norm)
          {
            best_norm   = norm;
            best_factor = factor;
          }
        else if (best_factor > 0.)
          break;
        if (norm < (1. - 0.5 * factor) * residual_norm)
          break;
      }
    return best_factor;
  }



  StaticStage::NewtonResult
  StaticStage::solve_load_step(const double load_share)
  {
    // Contact changes only once the forces are near their balance.
    constexpr double residual_for_contact = 1e-6;

    Vector step = grid.make_vector();
    increment.update_ghost_values();
    ElasticShare elastic_share;
    double       norm = evaluate(increment, load_share);
    for (unsigned int i = 0; i < parameters.maximum_iterations; ++i)
      {
        if (norm < residual_for_contact)
          {
            if (contact.update_contact() > 0)
              norm = evaluate(increment, load_share);
            else if (norm < parameters.relative_residual)
              return {true, i, norm};
          }

        equilibrium.assemble_tangent(contact, elastic_share.value(), tangent);
        SolverControl                  control;
        TrilinosWrappers::SolverDirect solver(control);
        try
          {
            solver.solve(tangent, step, residual);
          }
        catch (const std::exception &)
          {
            return {false, i, norm}; // a singular tangent
          }
        const double factor = search_line(step, norm, load_share);
        move_along(step,
                   factor == 0. && elastic_share.is_full() ? 0.125 : factor,
                   increment);
        elastic_share.adapt(factor);
        norm = evaluate(increment, load_share);
        if (!std::isfinite(norm))
          return {false, i, norm};
      }
    return {false, parameters.maximum_iterations, norm};
  }



  StaticState
  StaticStage::run()
  {
    double load = 0., step = 1. / parameters.n_load_steps, last_step = 0.;
    Vector last_increment = grid.make_vector();
    while (load < 1. - 1e-12)
      {
        const double this_step = std::min(step, 1. - load);
        // Material without cohesion deforms in proportion to its weight.
        increment.zero_out_ghost_values();
        increment = last_increment;
        increment *= last_step > 0. ? this_step / last_step : 0.;
        Vector weight = equilibrium.weight();
        weight *= load + this_step;
        weight.update_ghost_values();
        contact.set_weight(weight);

        const NewtonResult result = solve_load_step(load + this_step);
        log << "Load " << load + this_step << " of the weight: "
            << result.n_iterations << " iterations, residual "
            << result.residual
            << (result.has_converged ? "" : ", not converged: cut in half")
            << std::endl;
        if (result.has_converged)
          {
            load += this_step;
            last_step = this_step;
            increment.zero_out_ghost_values();
            last_increment      = increment;
            displacement_before = displacement;
            displacement_before.update_ghost_values();
            equilibrium.start_step(displacement_before);
            contact.commit();
            step = std::min(2. * step, 1. / parameters.n_load_steps);
          }
        else
          {
            contact.restore();
            step = this_step / 2.;
            if (step < parameters.smallest_load_step)
              throw RunError(
                "The static stage doesn't converge: at " +
                std::to_string(load + this_step) +
                " of the weight the residual is still " +
                std::to_string(result.residual) +
                " of it, and the load step is at its smallest. Try more Static "
                "stage/Load steps, a larger Maximum iterations, or another mesh.");
          }
      }
    return make_state();
  }



  StaticState
  StaticStage::make_state() const
  {
    const unsigned int n_points = grid.quadrature.size();
    StaticState        state;
    state.cells.resize(scene.triangulation.n_active_cells());
    state.wall_forces = contact.wall_forces();
    for (const auto &cell : grid.dof_handler.active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        const unsigned int index      = cell->active_cell_index();
        auto              &cell_state = state.cells[grid.scene_cells[index]];
        for (const unsigned int v : cell->vertex_indices())
          for (unsigned int d = 0; d < dim; ++d)
            cell_state.displacement[v][d] =
              displacement_before[cell->vertex_dof_index(v, d)];
        for (unsigned int q = 0; q < n_points; ++q)
          {
            const auto &point =
              equilibrium.material_points()[index * n_points + q];
            cell_state.stress[q]       = point.stress;
            cell_state.volume_ratio[q] = point.volume_ratio;
          }
      }
    return state;
  }



  void
  StaticStage::write_vtu(const std::string &directory) const
  {
    const std::vector<std::string> stress_names = {"stress_xx",
                                                   "stress_yy",
                                                   "stress_zz",
                                                   "stress_xy"};
    const unsigned int             n_points     = grid.quadrature.size();
    std::vector<dealii::Vector<float>> stresses(
      stress_names.size(),
      dealii::Vector<float>(grid.triangulation.n_active_cells()));
    for (const auto &cell : grid.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        for (unsigned int q = 0; q < n_points; ++q)
          for (unsigned int c = 0; c < stresses.size(); ++c)
            stresses[c][cell->active_cell_index()] +=
              equilibrium
                .material_points()[cell->active_cell_index() * n_points + q]
                .stress[c] /
              n_points;

    DataOut<dim> data_out;
    data_out.attach_dof_handler(grid.dof_handler);
    data_out.add_data_vector(
      displacement_before,
      std::vector<std::string>(dim, "displacement"),
      DataOut<dim>::type_dof_data,
      std::vector<DataComponentInterpretation::DataComponentInterpretation>(
        dim, DataComponentInterpretation::component_is_part_of_vector));
    for (unsigned int c = 0; c < stresses.size(); ++c)
      data_out.add_data_vector(stresses[c], stress_names[c]);
    data_out.build_patches(grid.mapping);
    data_out.write_vtu_with_pvtu_record(
      directory + "/", "static", 0, scene.communicator);
  }
} // namespace Sandglass
