#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/updated_lagrangian/rest_solver.h>

#include <algorithm>

namespace Sandglass
{
  namespace
  {
    /// A load step may end with an out-of-balance force of this share of its
    /// load: the material is not at rest, but the next load step can start.
    /// Loose grains beside rough walls go on moving in a long load step, whose
    /// stresses follow from its strain as a whole; the next one starts anew.
    constexpr double acceptable_share = 0.2;

    /// So many steps of dynamic relaxation are worth while for an exact end of
    /// a load step.
    constexpr unsigned int worthwhile_steps = 500;
  } // namespace



  template <int dim>
  RestSolver<dim>::RestSolver(const ElementGrid<dim>      &grid,
                              Equilibrium<dim>            &equilibrium,
                              WallContact<dim>            &contact,
                              const StaticStageParameters &parameters)
    : contact(contact)
    , parameters(parameters)
    , newton(grid, equilibrium, contact, parameters)
    , relaxation(grid, equilibrium, contact, newton.storage())
  {}



  template <int dim>
  RestResult
  RestSolver<dim>::solve(const Vector &displacement_before,
                         const double  load_share,
                         Vector       &increment)
  {
    // It may look long for the way from far off: where it finds one, there is
    // none faster.
    constexpr unsigned int patience = 20;

    RestResult   result{false, false, RestResult::Method::newton, 0, 0, 0, 0.};
    const Vector guess = increment;
    if (!try_newton(displacement_before,
                    load_share,
                    {parameters.maximum_iterations, patience},
                    increment,
                    result))
      {
        contact.restore();
        increment = guess;
        relax(displacement_before, load_share, increment, result);
      }
    result.is_acceptable =
      result.has_converged || result.residual < acceptable_share * load_share;
    if (!result.is_acceptable)
      contact.restore();
    return result;
  }



  template <int dim>
  bool
  RestSolver<dim>::try_newton(const Vector       &displacement_before,
                              const double        load_share,
                              const NewtonLimits &limits,
                              Vector             &increment,
                              RestResult         &result)
  {
    const NewtonResult last =
      newton.solve(displacement_before, load_share, limits, increment);
    result.has_converged = last.has_converged;
    result.residual      = last.residual;
    result.n_newton_iterations += last.n_iterations;
    result.n_linear_iterations += last.n_linear_iterations;
    return last.has_converged;
  }



  template <int dim>
  bool
  RestSolver<dim>::relax_to(const double       largest_residual,
                            const unsigned int most_steps,
                            Vector            &increment,
                            RestResult        &result)
  {
    const unsigned int most =
      std::min(most_steps, parameters.maximum_relaxation_steps);
    const RelaxationResult relaxed =
      relaxation.relax(largest_residual,
                       most - std::min(most, result.n_relaxation_steps),
                       increment);
    result.n_relaxation_steps += relaxed.n_steps;
    result.method   = RestResult::Method::relaxation;
    result.residual = relaxed.residual;
    return relaxed.has_converged;
  }



  template <int dim>
  void
  RestSolver<dim>::relax(const Vector &displacement_before,
                         const double  load_share,
                         Vector       &increment,
                         RestResult   &result)
  {
    // Near the solution Newton's method gets on all the time, though slowly
    // where material is separated, or not at all.
    constexpr NewtonLimits limits{100, 6};

    relaxation.start_step(displacement_before, load_share);
    double goal = 1e-2;
    while (!result.has_converged)
      {
        goal = std::max(goal / 10., parameters.relaxed_residual);
        if (!relax_to(goal, worthwhile_steps, increment, result))
          {
            relax_to(acceptable_share * load_share,
                     parameters.maximum_relaxation_steps,
                     increment,
                     result);
            return;
          }

        const auto   contact_before   = contact.active_supports();
        const Vector increment_before = increment;
        if (try_newton(
              displacement_before, load_share, limits, increment, result))
          result.method = RestResult::Method::relaxation_and_newton;
        else
          {
            increment = increment_before;
            contact.set_active_supports(contact_before);
            result.residual      = relaxation.evaluate(increment);
            result.has_converged = goal <= parameters.relaxed_residual;
          }
      }
  }



#define INSTANTIATE(dim) template class RestSolver<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
