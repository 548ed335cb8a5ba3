#ifndef sandglass_flow_updated_lagrangian_newton_solver_h
#define sandglass_flow_updated_lagrangian_newton_solver_h

#include <sandglass/flow/updated_lagrangian/out_of_balance.h>
#include <sandglass/flow/updated_lagrangian/static_stage_parameters.h>
#include <sandglass/flow/updated_lagrangian/tangent_matrix.h>
#include <sandglass/flow/updated_lagrangian/tangent_solver.h>

namespace Sandglass
{
  /// When Newton's method gives up.
  struct NewtonLimits
  {
    unsigned int most_iterations;
    /// Iterations in which the residual has to fall to a half.
    unsigned int patience;
  };

  /// How Newton's method ended.
  struct NewtonResult
  {
    bool         has_converged;
    unsigned int n_iterations;
    unsigned int n_linear_iterations; ///< of the TangentSolver
    double       residual;
  };

  /**
   * Newton's method for one step, at rest or in motion, with a line search.
   * Where the exact tangent gives no descent, elastic stiffness is mixed into
   * it until it does.
   */
  template <int dim>
  class NewtonSolver
  {
  public:
    using Vector = DisplacementVector;

    /// @param inertia  null at rest.
    /// @param relative_residual  where it stops; 0: as the parameters say.
    NewtonSolver(const ElementGrid<dim>      &grid,
                 Equilibrium<dim>            &equilibrium,
                 NodeConstraints<dim>        &contact,
                 const StaticStageParameters &parameters,
                 NewmarkInertia<dim>         *inertia           = nullptr,
                 const double                 relative_residual = 0.);

    using Result = NewtonResult;

    /**
     * @param[in]     displacement_before  at the start of the step.
     * @param[in,out] increment  of the displacement: initial guess in, result
     *                           out. Both with ghost entries.
     * @param[in]     load_share  share of gravity at the end of the step.
     * @param[in]     limits      where it fails.
     */
    Result
    solve(const Vector       &displacement_before,
          const double        load_share,
          const NewtonLimits &limits,
          Vector             &increment);

    /// By columns if tangents are factorized, by rows if they are inverted
    /// approximately.
    TangentStorage
    storage() const
    {
      return tangent.storage;
    }

  private:
    /// The iterations, without a count of linear ones.
    Result
    iterate(const NewtonLimits &limits, Vector &increment);

    /// Solve for the Newton step at the last evaluated iterate; false if the
    /// tangent is singular.
    bool
    find_step(const double elastic_share, const double residual_norm);

    /**
     * Go along the step by the factor that lowers the residual most among 1,
     * 1/2, ..., 1/32, and bring all state there.
     *
     * @return the factor, or 0 if none lowers the residual.
     */
    double
    search_line(Vector &increment, double &residual_norm);

    /// Go along the step by this factor, and bring all state there; returns the
    /// residual.
    double
    follow_step(Vector &increment, const double factor);

    /// `result` is the increment less the step times the factor.
    void
    move(const Vector &increment, const double factor, Vector &result) const;

    const double relative_residual;
    /// Whether factors may be those of the last step: a motion that goes on
    /// from a checkpoint has none.
    const bool        keeps_factors;
    OutOfBalance<dim> out_of_balance;

    TangentMatrix<dim> tangent;
    TangentSolver<dim> tangent_solver;
    Vector             step, trial;
  };
} // namespace Sandglass

#endif
