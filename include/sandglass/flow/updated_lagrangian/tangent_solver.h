#ifndef sandglass_flow_updated_lagrangian_tangent_solver_h
#define sandglass_flow_updated_lagrangian_tangent_solver_h

#include <sandglass/flow/updated_lagrangian/tangent_preconditioner.h>

#include <memory>
#include <vector>

namespace Sandglass
{
  /**
   * Linear solver for the tangents of Newton's method, which change little from
   * one iteration to the next: the inverse of an earlier tangent, or nearly so,
   * preconditions the method of generalized conjugate residuals (Eisenstat,
   * Elman and Schultz 1983), which finds what GMRES does with one application
   * of the preconditioner less. Where that takes too many iterations the
   * preconditioner is updated.
   */
  template <int dim>
  class TangentSolver
  {
  public:
    using Vector = DisplacementVector;

    TangentSolver(const TangentMatrix<dim>                   &tangent,
                  std::unique_ptr<TangentPreconditioner<dim>> preconditioner);

    /**
     * Solve with the tangent as it is now, to a residual of this share of the
     * right side or better. Collective.
     *
     * @return false if the tangent is singular, or too near to it.
     */
    bool
    solve(const Vector &right_side, const double tolerance, Vector &solution);

    /// Let the next solution start with a fresh preconditioner.
    void
    forget()
    {
      is_updated = false;
    }

    /// Number of iterations since the beginning.
    unsigned int
    n_iterations() const
    {
      return n_all_iterations;
    }

  private:
    /// A direction in which the solution has been improved, and the tangent
    /// times it, whose norm is 1.
    struct Improvement
    {
      Vector direction, image;
    };

    /// Solve with the preconditioner as it is; false if it is too old.
    bool
    iterate(const Vector &right_side, const double tolerance, Vector &solution);

    /// Add to the solution what lowers the residual most among the sums of a
    /// new direction and the last `n`; false if there is none.
    bool
    improve(const unsigned int n, Vector &solution);

    bool
    update();

    const TangentMatrix<dim>                         &tangent;
    const std::unique_ptr<TangentPreconditioner<dim>> preconditioner;
    bool                                              is_updated       = false;
    unsigned int                                      n_all_iterations = 0;
    /// Counts since the preconditioner's update: solutions found, iterations
    /// for these and for the last of them.
    unsigned int n_solutions = 0, n_their_iterations = 0, last_iterations = 0;

    Vector                   residual;
    std::vector<Improvement> improvements;
  };
} // namespace Sandglass

#endif
