#include <deal.II/dofs/dof_tools.h>

#include <sandglass/choices.h>
#include <sandglass/flow/updated_lagrangian/tangent_preconditioner.h>

#include <Amesos.h>
#include <Epetra_CrsMatrix.h>
#include <Epetra_Vector.h>
#include <Teuchos_ParameterList.hpp>

namespace Sandglass
{
  namespace
  {
    // What an update takes, in iterations, as measured. Factors take more on
    // finer meshes, where multigrid is the better choice.
    constexpr unsigned int cost_of_factors = 14, cost_of_multigrid = 20;

    /// A solution with a fresh multigrid takes a sixth of these iterations.
    constexpr unsigned int most_multigrid_iterations = 300;
  } // namespace



  template <int dim>
  TangentFactors<dim>::TangentFactors(const TangentMatrix<dim> &tangent)
    : TangentPreconditioner<dim>(cost_of_factors, cost_of_factors)
    , matrix(tangent.stored_matrix().trilinos_matrix())
  {
    // Amesos only reads the matrix, but asks for one that it could change.
    problem.SetOperator(const_cast<Epetra_CrsMatrix *>(&matrix));
    factors.reset(Amesos().Create("Amesos_Klu", problem));
    AssertThrow(factors, ExcMessage("This Trilinos has no Amesos_Klu."));

    Teuchos::ParameterList settings;
    settings.set("Refactorize", true);
    factors->SetParameters(settings);
    factors->SetUseTranspose(true);
    const int status = factors->SymbolicFactorization();
    AssertThrow(status == 0, ExcTrilinosError(status));
  }



  template <int dim>
  bool
  TangentFactors<dim>::update()
  {
    return factors->NumericFactorization() == 0;
  }



  template <int dim>
  void
  TangentFactors<dim>::vmult(DisplacementVector       &solution,
                             const DisplacementVector &right_side)
  {
    Epetra_Vector x(View, matrix.DomainMap(), solution.begin());
    Epetra_Vector b(View,
                    matrix.RangeMap(),
                    const_cast<double *>(right_side.begin()));
    problem.SetLHS(&x);
    problem.SetRHS(&b);
    const int status = factors->Solve();
    AssertThrow(status == 0, ExcTrilinosError(status));
  }



  template <int dim>
  TangentMultigrid<dim>::TangentMultigrid(const ElementGrid<dim>   &grid,
                                          const TangentMatrix<dim> &tangent)
    : TangentPreconditioner<dim>(cost_of_multigrid, most_multigrid_iterations)
    , tangent(tangent)
  {
    settings.elliptic = true;
    DoFTools::extract_constant_modes(grid.dof_handler,
                                     ComponentMask(),
                                     settings.constant_modes);
    // Ranks without unknowns get none, but have to ask for the same as others.
    settings.constant_modes.resize(dim);
    // Chebyshev's method, deal.II's choice, needs half as many iterations
    // again: friction makes the tangent unsymmetric.
    settings.smoother_type   = "symmetric Gauss-Seidel";
    settings.smoother_sweeps = 2;
  }



  template <int dim>
  bool
  TangentMultigrid<dim>::update()
  {
    multigrid.initialize(tangent.stored_matrix(), settings);
    return true;
  }



  template <int dim>
  void
  TangentMultigrid<dim>::vmult(DisplacementVector       &solution,
                               const DisplacementVector &right_side)
  {
    multigrid.vmult(solution, right_side);
  }



  template <int dim>
  std::unique_ptr<TangentPreconditioner<dim>>
  make_preconditioner(const ElementGrid<dim>   &grid,
                      const TangentMatrix<dim> &tangent)
  {
    if (tangent.storage == TangentStorage::columns)
      return std::make_unique<TangentFactors<dim>>(tangent);
    return std::make_unique<TangentMultigrid<dim>>(grid, tangent);
  }



#define INSTANTIATE(dim)                                                    \
  template class TangentFactors<dim>;                                       \
  template class TangentMultigrid<dim>;                                     \
  template std::unique_ptr<TangentPreconditioner<dim>> make_preconditioner( \
    const ElementGrid<dim> &, const TangentMatrix<dim> &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
