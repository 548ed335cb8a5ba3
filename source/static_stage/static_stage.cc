#include <deal.II/dofs/dof_tools.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/trilinos_solver.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/static_stage/static_stage.h>

#include <iostream>
#include <cstdlib>

namespace Sandglass
{
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



  StaticStage::NewtonResult
  StaticStage::solve_load_step(const double load_share)
  {
    static const bool verbose = std::getenv("VERBOSE");
    increment.update_ghost_values();
    { Vector w = equilibrium.weight(); w *= load_share; w.update_ghost_values(); contact.set_weight(w); }
    double norm = evaluate(increment, load_share);
    if (verbose)
      std::cout << "   start " << norm << std::endl;
    Vector       step = grid.make_vector(), trial = grid.make_vector();
    unsigned int iteration = 0;
    double beta = 0.;
    for (; iteration < parameters.maximum_iterations; ++iteration)
      {
        if (norm < 1e-6)
          {
            const unsigned int n = contact.update_contact();
            if (verbose && n)
              std::cout << "   contact changes " << n << std::endl;
            if (n > 0)
              norm = evaluate(increment, load_share);
            else if (norm < parameters.relative_residual)
              return {true, iteration, norm};
          }
        static const double b0=std::getenv("B0")?std::atof(std::getenv("B0")):1e-2;
        auto env=[](const char*n,double d){return std::getenv(n)?std::atof(std::getenv(n)):d;};
        static const double fb=env("FB",.125), gr=env("GR",4), sh=env("SH",4);
        static const int nls=std::getenv("NLS")?std::atoi(std::getenv("NLS")):4;
        equilibrium.elastic_share = beta;
        equilibrium.assemble_tangent(contact, tangent);
        SolverControl                  control;
        TrilinosWrappers::SolverDirect solver(control);
        try
          {
            solver.solve(tangent, step, residual);
          }
        catch (const std::exception &e)
          {
            if (verbose)
              std::cout << "solver: " << e.what() << std::endl;
            return {false, iteration, norm};
          }
        double best_norm = norm, best_factor = 0, factor = 1., new_norm = 0.;
        for (int i = 0; i < nls; ++i, factor /= 2.)
          {
            trial.zero_out_ghost_values();
            increment.zero_out_ghost_values();
            trial = increment;
            trial.add(-factor, step);
            trial.update_ghost_values();
            new_norm = evaluate(trial, load_share);
            if (new_norm < best_norm)
              {
                best_norm   = new_norm;
                best_factor = factor;
              }
            else if (best_factor > 0)
              break;
            if (new_norm < (1. - 0.5 * factor) * norm)
              break;
          }
        if (best_factor == 0.)
          {
            if (beta == 1.) 
               best_factor = fb;
            beta = beta == 0. ? b0 : std::min(1., beta * gr);
          }
        else if (best_factor < 0.5) beta = beta == 0. ? b0 : beta;
        else
          beta = beta <= b0 ? 0. : beta / sh;
        increment.zero_out_ghost_values();
        increment.add(-best_factor, step);
        increment.update_ghost_values();
        norm = evaluate(increment, load_share);
        if (verbose)
          std::cout << "   " << iteration << " factor " << best_factor
                    << " beta " << beta << " residual " << norm << " sliding "
                      << contact.n_sliding() << " |inc| " << increment.linfty_norm() << " |step| " << step.linfty_norm()
                    << [&]() { int n[3]={0,0,0}; for (auto &p : equilibrium.material_points()) { const double P=pressure(p.trial_stress), q=von_mises_stress(p.trial_stress); ++n[P<=0?2:q>material.yield_slope*P?1:0]; } return " el "+std::to_string(n[0])+" pl "+std::to_string(n[1])+" sep "+std::to_string(n[2]); }() << std::endl;
        if (!std::isfinite(norm))
          break;
      }
    return {false, iteration, norm};
  }



  StaticState
  StaticStage::run()
  {
    double       load = 0., step = 1. / parameters.n_load_steps;
    double       last_step = 0.;
    Vector       last      = grid.make_vector();
    while (load < 1. - 1e-12)
      {
        const double this_step = std::min(step, 1. - load);
        increment.zero_out_ghost_values();
        increment = 0.;
        last.zero_out_ghost_values();
        if (last_step > 0.)
          increment.add(this_step / last_step, last);
        const auto result = solve_load_step(load + this_step);
        log << "  load step to " << load + this_step << ": "
            << result.n_iterations << " iterations, residual "
            << result.residual << (result.has_converged ? "" : " FAILED")
            << std::endl;
        if (result.has_converged)
          {
            load += this_step;
            last_step = this_step;
            increment.zero_out_ghost_values();
            last = increment;
            displacement_before = displacement;
            displacement_before.update_ghost_values();
            equilibrium.start_step(displacement_before);
            contact.commit();
          }
        else
          {
            contact.restore();
            step = this_step / 2.;
            if (step < parameters.smallest_load_step)
              throw RunError("no convergence");
          }
      }
    return StaticState();
  }
} // namespace Sandglass
