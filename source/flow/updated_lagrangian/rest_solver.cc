#include <sandglass/choices.h>
#include <sandglass/flow/updated_lagrangian/rest_solver.h>

#include <algorithm>

namespace Sandglass
{
  template <int dim>
  RestSolver<dim>::RestSolver(const FilledGrid<dim>       &grid,
                              Equilibrium<dim>            &equilibrium,
                              WallContact<dim>            &contact,
                              const StaticStageParameters &parameters)
    : contact(contact)
    , parameters(parameters)
    , newton(grid, equilibrium, contact, parameters)
    , relaxation(grid, equilibrium, contact)
  {}



  template <int dim>
  RestResult
  RestSolver<dim>::solve(const Vector &displacement_before,
                         const double  load_share,
                         Vector       &increment)
  {
    RestResult   result{false, RestResult::Method::newton, 0, 0, 0, 0.};
    const Vector guess = increment;
    if (!try_newton(displacement_before,
                    load_share,
                    parameters.maximum_iterations,
                    increment,
                    result))
      {
        contact.restore();
        increment = guess;
        relax(displacement_before, load_share, increment, result);
      }
    if (!result.has_converged)
      contact.restore();
    return result;
  }



  template <int dim>
  bool
  RestSolver<dim>::try_newton(const Vector      &displacement_before,
                              const double       load_share,
                              const unsigned int most_iterations,
                              Vector            &increment,
                              RestResult        &result)
  {
    const NewtonResult last =
      newton.solve(displacement_before, load_share, most_iterations, increment);
    result.has_converged = last.has_converged;
    result.residual      = last.residual;
    result.n_newton_iterations += last.n_iterations;
    result.n_linear_iterations += last.n_linear_iterations;
    return last.has_converged;
  }



  template <int dim>
  void
  RestSolver<dim>::relax(const Vector &displacement_before,
                         const double  load_share,
                         Vector       &increment,
                         RestResult   &result)
  {
    // Near the solution Newton's method needs a few iterations, or fails.
    constexpr unsigned int most_iterations = 12;

    relaxation.start_step(displacement_before, load_share);
    double goal = 1e-2;
    while (true)
      {
        goal = std::max(goal / 10., parameters.relaxed_residual);
        const RelaxationResult relaxed =
          relaxation.relax(goal,
                           parameters.maximum_relaxation_steps -
                             result.n_relaxation_steps,
                           increment);
        result.n_relaxation_steps += relaxed.n_steps;
        result.method   = RestResult::Method::relaxation;
        result.residual = relaxed.residual;
        if (!relaxed.has_converged)
          return;

        const auto   contact_before   = contact.active_supports();
        const Vector increment_before = increment;
        if (try_newton(displacement_before,
                       load_share,
                       most_iterations,
                       increment,
                       result))
          {
            result.method = RestResult::Method::relaxation_and_newton;
            return;
          }
        increment = increment_before;
        contact.set_active_supports(contact_before);
        if (goal <= parameters.relaxed_residual)
          {
            result.residual      = relaxation.evaluate(increment);
            result.has_converged = true;
            return;
          }
      }
  }



#define INSTANTIATE(dim) template class RestSolver<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
