#ifndef sandglass_flow_updated_lagrangian_rest_solver_h
#define sandglass_flow_updated_lagrangian_rest_solver_h

#include <sandglass/flow/updated_lagrangian/dynamic_relaxation.h>
#include <sandglass/flow/updated_lagrangian/newton_solver.h>

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

    bool         has_converged;
    Method       method;
    unsigned int n_newton_iterations;
    unsigned int n_linear_iterations; ///< of the TangentSolver
    unsigned int n_relaxation_steps;
    double       residual; ///< see OutOfBalance
  };

  /**
   * One load step, by Newton's method where it finds the way. Where it doesn't,
   * DynamicRelaxation goes towards rest, and Newton's method tries again from
   * nearer and nearer. Both solve the same equations from the same state.
   */
  template <int dim>
  class RestSolver
  {
  public:
    using Vector = DisplacementVector;

    RestSolver(const FilledGrid<dim>       &grid,
               Equilibrium<dim>            &equilibrium,
               WallContact<dim>            &contact,
               const StaticStageParameters &parameters);

    /**
     * Contact is that of the start of the load step, and again so if the step
     * does not converge.
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
      return newton.is_direct();
    }

  private:
    /// Newton's method; adds its effort to the result.
    bool
    try_newton(const Vector      &displacement_before,
               const double       load_share,
               const unsigned int most_iterations,
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
