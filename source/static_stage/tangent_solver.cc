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
    /// New factors cost about as much as so many iterations.
    constexpr unsigned int factorization_cost = 14;
  } // namespace



  TangentSolver::TangentSolver(const TangentMatrix &tangent)
    : tangent(tangent)
    , problem(std::make_unique<Epetra_LinearProblem>())
  {
    // Amesos only reads the matrix, but asks for one that it could change.
    problem->SetOperator(const_cast<Epetra_CrsMatrix *>(
      &tangent.stored_matrix().trilinos_matrix()));
    factors.reset(Amesos().Create("Amesos_Klu", *problem));
    AssertThrow(factors, ExcMessage("This Trilinos has no Amesos_Klu."));

    Teuchos::ParameterList settings;
    settings.set("Refactorize", true);
    factors->SetParameters(settings);
    factors->SetUseTranspose(true);
    const int status = factors->SymbolicFactorization();
    AssertThrow(status == 0, ExcTrilinosError(status));
  }



  bool
  TangentSolver::solve(const Vector &right_side,
                       const double  tolerance,
                       Vector       &solution)
  {
    // The factors age. New ones are due when the last solution took more
    // iterations than one does on average, the factors' cost shared out.
    const bool is_due =
      last_iterations * n_solutions > factorization_cost + n_iterations;
    if (has_factors && !is_due && iterate(right_side, tolerance, solution))
      return true;
    return factorize() && iterate(right_side, tolerance, solution);
  }



  bool
  TangentSolver::iterate(const Vector &right_side,
                         const double  tolerance,
                         Vector       &solution)
  {
    solution.zero_out_ghost_values();
    solution            = 0.;
    residual            = right_side;
    const double target = tolerance * right_side.l2_norm();
    unsigned int n      = 0;
    for (; !(residual.l2_norm() <= target); ++n)
      {
        if (n == factorization_cost)
          return false;
        if (n == improvements.size())
          improvements.push_back({right_side, right_side});
        auto &[direction, image] = improvements[n];
        apply_factors(residual, direction);
        tangent.vmult(image, direction);
        for (unsigned int i = 0; i < n; ++i)
          {
            const double share = image * improvements[i].image;
            direction.add(-share, improvements[i].direction);
            image.add(-share, improvements[i].image);
          }
        const double norm = image.l2_norm();
        if (!(norm > 0.) || !std::isfinite(norm))
          return false;
        direction /= norm;
        image /= norm;

        const double factor = residual * image;
        solution.add(factor, direction);
        residual.add(-factor, image);
      }
    last_iterations = n;
    n_iterations += n;
    ++n_solutions;
    return true;
  }



  bool
  TangentSolver::factorize()
  {
    has_factors  = factors->NumericFactorization() == 0;
    n_iterations = n_solutions = last_iterations = 0;
    return has_factors;
  }



  void
  TangentSolver::apply_factors(const Vector &right_side, Vector &solution) const
  {
    const Epetra_CrsMatrix &crs_matrix =
      tangent.stored_matrix().trilinos_matrix();
    Epetra_Vector x(View, crs_matrix.DomainMap(), solution.begin());
    Epetra_Vector b(View,
                    crs_matrix.RangeMap(),
                    const_cast<double *>(right_side.begin()));
    problem->SetLHS(&x);
    problem->SetRHS(&b);
    const int status = factors->Solve();
    AssertThrow(status == 0, ExcTrilinosError(status));
  }
} // namespace Sandglass
