#ifndef sandglass_static_stage_tangent_solver_h
#define sandglass_static_stage_tangent_solver_h

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <sandglass/static_stage/filled_grid.h>

#include <Amesos_BaseSolver.h>
#include <Epetra_LinearProblem.h>

#include <memory>

namespace Sandglass
{
  /**
   * Linear solver for the tangents of Newton's method, which change little from
   * one iteration to the next: GMRES with the factors of an earlier tangent as
   * its preconditioner, and new factors where that takes too many iterations.
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

    /// @param matrix  the tangent, which may change; its sparsity may not.
    explicit TangentSolver(const TrilinosWrappers::SparseMatrix &matrix);

    /**
     * Solve with the tangent as it is now, to a residual of this share of the
     * right side or better. Collective.
     *
     * @return false if the tangent is singular.
     */
    bool
    solve(const Vector &right_side, const double tolerance, Vector &solution);

    /// Multiply by the inverse of the tangent that the factors belong to; what
    /// deal.II asks of a preconditioner.
    void
    vmult(Vector &solution, const Vector &right_side) const;

  private:
    bool
    solve_iteratively(const Vector &right_side,
                      const double  tolerance,
                      Vector       &solution);

    bool
    factorize();

    const TrilinosWrappers::SparseMatrix &matrix;
    std::unique_ptr<Epetra_LinearProblem> problem;
    std::unique_ptr<Amesos_BaseSolver>    factors;
    bool                                  has_factors = false;
    /// With the present factors.
    unsigned int n_iterations = 0;
  };
} // namespace Sandglass

#endif
