#include <sandglass/base/exceptions.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/updated_lagrangian/newmark_motion.h>
#include <sandglass/material/law_failure.h>

#include <algorithm>
#include <sstream>

namespace Sandglass
{
  namespace
  {
    /// Where Newton's method gives up. A step with inertia that needs more is
    /// quicker done as two.
    constexpr NewtonLimits limits{40, 15};

    /// After more of Newton's iterations steps don't grow: twice as long ones
    /// would probably fail.
    constexpr unsigned int easy = 12;

    /// Of the volume at a quadrature point in one step: strain within a step is
    /// taken as small.
    constexpr double smallest_volume_ratio = 0.5;

    /// As a share of the one asked for.
    constexpr double smallest_step = 1. / 1024.;

    /// In this share of a step inertia is so much larger than what stiffness
    /// adds that the solution is the acceleration at its start.
    constexpr double instant = 1e-6;
  } // namespace



  template <int dim>
  NewmarkMotion<dim>::NewmarkMotion(
    const ElementGrid<dim>      &grid,
    Equilibrium<dim>            &equilibrium,
    const ConsistentMass<dim>   &mass,
    NodeConstraints<dim>        &constraints,
    const Parameters            &parameters,
    const StaticStageParameters &solver_parameters,
    const double                 relative_residual)
    : parameters(parameters)
    , equilibrium(equilibrium)
    , constraints(constraints)
    , inertia(grid, mass, parameters.newmark)
    , newton(grid,
             equilibrium,
             constraints,
             solver_parameters,
             &inertia,
             relative_residual)
    , next_step(parameters.time_step)
    , total_displacement(grid.make_vector())
  {}



  template <int dim>
  void
  NewmarkMotion<dim>::start(const Vector &displacement, const Vector &velocity)
  {
    now                = 0.;
    last_step          = 0.;
    next_step          = parameters.time_step;
    total_displacement = displacement;
    total_displacement.update_ghost_values();
    find_acceleration();
    inertia.velocity = velocity;
    inertia.velocity.update_ghost_values();
  }



  template <int dim>
  void
  NewmarkMotion<dim>::go_on(const double  time,
                            const double  first_step,
                            const Vector &displacement,
                            const Vector &velocity,
                            const Vector &acceleration)
  {
    now                  = time;
    last_step            = 0.;
    next_step            = first_step;
    total_displacement   = displacement;
    inertia.velocity     = velocity;
    inertia.acceleration = acceleration;
    correct_motion();
    total_displacement.update_ghost_values();
  }



  template <int dim>
  void
  NewmarkMotion<dim>::correct_motion()
  {
    for (Vector *vector : {&inertia.velocity, &inertia.acceleration})
      vector->zero_out_ghost_values();
    constraints.correct_motion(inertia.velocity, inertia.acceleration);
    for (Vector *vector : {&inertia.velocity, &inertia.acceleration})
      vector->update_ghost_values();
  }



  template <int dim>
  void
  NewmarkMotion<dim>::find_acceleration()
  {
    // Without velocity, whose share of the increment would drown the
    // acceleration's.
    inertia.velocity     = 0.;
    inertia.acceleration = 0.;
    Vector increment(total_displacement);
    if (!solve(instant * parameters.time_step, increment))
      throw RunError("The motion cannot start: no acceleration is in balance "
                     "with the forces. Check the state at rest.");
    inertia.end_step(increment);
  }



  template <int dim>
  bool
  NewmarkMotion<dim>::solve(const double time_step, Vector &increment)
  {
    // The smallest alpha that damps all short waves with this delta.
    constexpr NewmarkParameters damping{1., 0.5625};
    inertia.set_parameters(is_damped ? damping : parameters.newmark);
    inertia.start_step(time_step);
    equilibrium.set_time_step(time_step);
    increment = inertia.increment_of_steady_acceleration();
    if (is_damped)
      {
        increment.zero_out_ghost_values();
        increment.equ(time_step, inertia.velocity);
        increment.update_ghost_values();
      }
    try
      {
        const NewtonResult result = newton.solve(total_displacement,
                                                 load_share(now + time_step),
                                                 limits,
                                                 increment);
        so_far.n_iterations += result.n_iterations;
        last_iterations = result.n_iterations;
        if (result.has_converged &&
            increment.linfty_norm() <= parameters.longest_way &&
            equilibrium.smallest_volume_ratio() > smallest_volume_ratio)
          return true;
      }
    catch (const LawFailure &)
      {
        // A shorter step asks less of the law.
      }
    ++so_far.n_failures;
    constraints.restore();
    return false;
  }



  template <int dim>
  void
  NewmarkMotion<dim>::accept(const double time_step, const Vector &increment)
  {
    total_displacement.zero_out_ghost_values();
    total_displacement.add(1., increment);
    total_displacement.update_ghost_values();
    inertia.end_step(increment);
    equilibrium.start_step();
    constraints.commit();
    correct_motion();
    is_damped = false;
    now += time_step;
    last_step = time_step;
  }



  template <int dim>
  bool
  NewmarkMotion<dim>::has_smallest_step() const
  {
    return next_step < smallest_step * parameters.time_step;
  }



  template <int dim>
  bool
  NewmarkMotion<dim>::try_step(const double longest)
  {
    Vector       increment(total_displacement);
    const double time_step = std::min(longest, next_step);
    if (!solve(time_step, increment))
      {
        next_step = time_step / 2.;
        return false;
      }
    accept(time_step, increment);
    // A step that was cut short at the end of some time says nothing.
    if (time_step == next_step && last_iterations <= easy)
      next_step = std::min(2. * time_step, parameters.time_step);
    return true;
  }



  template <int dim>
  void
  NewmarkMotion<dim>::step()
  {
    while (!try_step(parameters.time_step))
      if (has_smallest_step())
        {
          std::ostringstream message;
          message << "The motion stopped at " << now
                  << " s: no step from there down to " << 2. * next_step
                  << " s has a solution. Try smaller elements or a smaller "
                     "'Time step'.";
          throw RunError(message.str());
        }
  }



  template <int dim>
  typename NewmarkMotion<dim>::Energies
  NewmarkMotion<dim>::energies() const
  {
    const auto of_material = equilibrium.energies();
    return {inertia.mass.kinetic_energy(inertia.velocity),
            of_material.elastic,
            of_material.dissipated,
            -1. * (equilibrium.weight() * total_displacement)};
  }



#define INSTANTIATE(dim) template class NewmarkMotion<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
