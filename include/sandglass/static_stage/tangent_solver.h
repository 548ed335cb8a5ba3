#ifndef sandglass_static_stage_tangent_solver_h
#define sandglass_static_stage_tangent_solver_h

#include <sandglass/static_stage/tangent_matrix.h>

#include <Amesos_BaseSolver.h>
#include <Epetra_LinearProblem.h>

#include <memory>
#include <vector>

namespace Sandglass
{
  /**
   * Linear solver for the tangents of Newton's method, which change little from
   * one iteration to the next: the factors of an earlier tangent precondition
   * the method of generalized conjugate residuals (Eisenstat, Elman and Schultz
   * 1983), which finds what GMRES does with one application of the factors
   * less. Where that takes too many iterations there are new factors.
   *
   * The factors are those of Trilinos' direct solver KLU, by Amesos. The order
   * of elimination is found once, and the pivots serve again as long as the
   * result is well conditioned. deal.II's interface to Amesos would begin from
   * nothing each time.
   */
  class TangentSolver
  {
  public:
    using Vector = FilledGrid::Vector;

    /// @param tangent  stored by columns.
    explicit TangentSolver(const TangentMatrix &tangent);

    /**
     * Solve with the tangent as it is now, to a residual of this share of the
     * right side or better. Collective.
     *
     * @return false if the tangent is singular.
     */
    bool
    solve(const Vector &right_side, const double tolerance, Vector &solution);

  private:
    /// A direction in which the solution has been improved, and the tangent
    /// times it, whose norm is 1.
    struct Improvement
    {
      Vector direction, image;
    };

    /// With the factors as they are; false if they are too old.
    bool
    iterate(const Vector &right_side, const double tolerance, Vector &solution);

    /// Multiply by the inverse of the tangent that the factors belong to.
    void
    apply_factors(const Vector &right_side, Vector &solution) const;

    bool
    factorize();

    const TangentMatrix                  &tangent;
    std::unique_ptr<Epetra_LinearProblem> problem;
    std::unique_ptr<Amesos_BaseSolver>    factors;
    bool                                  has_factors = false;
    /// Of the present factors: solutions found with them, iterations for these
    /// and for the last of them.
    unsigned int n_solutions = 0, n_iterations = 0, last_iterations = 0;

    Vector                   residual;
    std::vector<Improvement> improvements;
  };
} // namespace Sandglass

#endif
