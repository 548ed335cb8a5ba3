#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

#include <sandglass/static_stage/tangent_solver.h>

#include <Amesos.h>
#include <Epetra_CrsMatrix.h>
#include <Epetra_Vector.h>
#include <Teuchos_ParameterList.hpp>

#include <cmath>

namespace Sandglass
{
  namespace
  {
    /// As GMRES goes on, its iterations gain less. New factors cost about as
    /// much as ten iterations.
    constexpr unsigned int most_iterations_at_once = 8;

    /// Factors that have needed so many iterations are too old.
    constexpr unsigned int most_iterations = 15;
  } // namespace



  TangentSolver::TangentSolver(const TrilinosWrappers::SparseMatrix &matrix)
    : matrix(matrix)
    , problem(std::make_unique<Epetra_LinearProblem>())
  {
    // Amesos only reads the matrix, but asks for one that it could change.
    problem->SetOperator(
      const_cast<Epetra_CrsMatrix *>(&matrix.trilinos_matrix()));
    factors.reset(Amesos().Create("Amesos_Klu", *problem));
    AssertThrow(factors, ExcMessage("This Trilinos has no Amesos_Klu."));

    Teuchos::ParameterList settings;
    settings.set("Refactorize", true);
    factors->SetParameters(settings);
    const int status = factors->SymbolicFactorization();
    AssertThrow(status == 0, ExcTrilinosError(status));
  }



  bool
  TangentSolver::solve(const Vector &right_side,
                       const double  tolerance,
                       Vector       &solution)
  {
    solution.zero_out_ghost_values();
    if (has_factors && solve_iteratively(right_side, tolerance, solution))
      return std::isfinite(solution.l2_norm());
    if (!factorize())
      return false;
    vmult(solution, right_side);
    return std::isfinite(solution.l2_norm());
  }



  bool
  TangentSolver::solve_iteratively(const Vector &right_side,
                                   const double  tolerance,
                                   Vector       &solution)
  {
    if (n_iterations >= most_iterations)
      return false;
    SolverControl control(most_iterations_at_once,
                          tolerance * right_side.l2_norm());
    // Preconditioned from the right, so that its residual is the real one.
    constexpr bool      from_the_right = true;
    SolverGMRES<Vector> solver(control,
                               SolverGMRES<Vector>::AdditionalData(
                                 most_iterations_at_once + 2, from_the_right));
    solution = 0.;
    try
      {
        solver.solve(matrix, solution, right_side, *this);
      }
    catch (const SolverControl::NoConvergence &)
      {
        return false;
      }
    n_iterations += control.last_step();
    return true;
  }



  bool
  TangentSolver::factorize()
  {
    has_factors  = factors->NumericFactorization() == 0;
    n_iterations = 0;
    return has_factors;
  }



  void
  TangentSolver::vmult(Vector &solution, const Vector &right_side) const
  {
    const Epetra_CrsMatrix &crs_matrix = matrix.trilinos_matrix();
    Epetra_Vector           x(View, crs_matrix.DomainMap(), solution.begin());
    Epetra_Vector           b(View,
                    crs_matrix.RangeMap(),
                    const_cast<double *>(right_side.begin()));
    problem->SetLHS(&x);
    problem->SetRHS(&b);
    const int status = factors->Solve();
    AssertThrow(status == 0, ExcTrilinosError(status));
  }
} // namespace Sandglass
