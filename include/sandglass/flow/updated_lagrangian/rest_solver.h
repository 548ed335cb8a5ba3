#ifndef sandglass_flow_updated_lagrangian_rest_solver_h
#define sandglass_flow_updated_lagrangian_rest_solver_h

#include <sandglass/flow/updated_lagrangian/dynamic_relaxation.h>
#include <sandglass/flow/updated_lagrangian/newton_solver.h>
#include <sandglass/flow/updated_lagrangian/wall_contact.h>

namespace Sandglass
{
  /// How a load step has been solved.
  struct RestResult
  {
    /// By Newton's method alone, by relaxation and Newton's method, or by
    /// relaxation alone.
    enum class Method
    {
      newton,
      relaxation_and_newton,
      relaxation
    };

    bool has_converged;
    /// Whether the next load step can start here: at rest, or so near to it
    /// that most of the load is carried.
    bool         is_acceptable;
    Method       method;
    unsigned int n_newton_iterations;
    unsigned int n_linear_iterations; ///< of the TangentSolver
    unsigned int n_relaxation_steps;
    double       residual; ///< see OutOfBalance
  };

  /**
   * One load step, by Newton's method where it finds the way. Where it doesn't,
   * DynamicRelaxation goes towards rest, and Newton's method tries again from
   * nearer and nearer. Both solve the same equations from the same state. Where
   * that takes long, the step ends as soon as most of the load is carried.
   */
  template <int dim>
  class RestSolver
  {
  public:
    using Vector = DisplacementVector;

    RestSolver(const ElementGrid<dim>      &grid,
               Equilibrium<dim>            &equilibrium,
               WallContact<dim>            &contact,
               const StaticStageParameters &parameters);

    /**
     * Contact is that of the start of the load step, and again so if the
     * result is not acceptable.
     *
     * @param displacement_before  at the start of the load step.
     * @param load_share           share of gravity at its end.
     * @param[in,out] increment    of the displacement: initial guess in, result
     *                             out. Both with ghost entries.
     */
    RestResult
    solve(const Vector &displacement_before,
          const double  load_share,
          Vector       &increment);

    /// Whether Newton's tangents are factorized, or inverted approximately.
    bool
    is_direct() const
    {
      return newton.storage() == TangentStorage::columns;
    }

  private:
    /// Newton's method; adds its effort to the result.
    bool
    try_newton(const Vector       &displacement_before,
               const double        load_share,
               const NewtonLimits &limits,
               Vector             &increment,
               RestResult         &result);

    /// The relaxation until the residual is small, or until so many steps have
    /// been made in all; adds its effort to the result.
    bool
    relax_to(const double       largest_residual,
             const unsigned int most_steps,
             Vector            &increment,
             RestResult        &result);

    /// The relaxation, with Newton's method from time to time.
    void
    relax(const Vector &displacement_before,
          const double  load_share,
          Vector       &increment,
          RestResult   &result);

    WallContact<dim>            &contact;
    const StaticStageParameters &parameters;
    NewtonSolver<dim>            newton;
    DynamicRelaxation<dim>       relaxation;
  };
} // namespace Sandglass

#endif
