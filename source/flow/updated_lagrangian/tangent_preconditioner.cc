#include <deal.II/dofs/dof_tools.h>

#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/updated_lagrangian/tangent_preconditioner.h>

#include <Amesos.h>
#include <Epetra_CrsMatrix.h>
#include <Epetra_MultiVector.h>
#include <Epetra_Vector.h>
#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <map>

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
    if constexpr (dim == 3)
      find_rigid_modes(grid);
  }



  template <int dim>
  void
  TangentMultigrid<dim>::find_rigid_modes(const ElementGrid<dim> &grid)
  {
    std::map<types::global_dof_index, Point<dim>> positions;
    DoFTools::map_dofs_to_support_points(grid.mapping,
                                         grid.dof_handler,
                                         positions);
    // All ranks know all vertices.
    const auto &vertices = grid.triangulation.get_vertices();
    Point<dim>  centre;
    for (const Point<dim> &vertex : vertices)
      centre += vertex / static_cast<double>(vertices.size());
    double size = 0.;
    for (const Point<dim> &vertex : vertices)
      size = std::max(size, vertex.distance(centre));

    const unsigned int n_owned = grid.n_owned_dofs();
    rigid_modes.assign(n_rigid_modes * n_owned, 0.);
    for (const auto &local_cell : grid.local_cells)
      {
        std::vector<types::global_dof_index> dofs(
          grid.finite_element.n_dofs_per_cell());
        local_cell.cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            const unsigned int at = local_cell.dofs[i];
            if (at >= n_owned)
              continue;
            const unsigned int   d   = grid.component(i);
            const Tensor<1, dim> arm = (positions.at(dofs[i]) - centre) / size;
            rigid_modes[d * n_owned + at] = 1.;
            // About the axis k a point moves by e_k x arm.
            for (unsigned int k = 0; k < dim; ++k)
              if (k != d)
                rigid_modes[(dim + k) * n_owned + at] =
                  ((k + 1) % dim == d ? -1. : 1.) * arm[dim - k - d];
          }
      }
  }



  template <int dim>
  bool
  TangentMultigrid<dim>::update()
  {
    if constexpr (dim == 2)
      multigrid.initialize(tangent.stored_matrix(), settings);
    else
      {
        Teuchos::ParameterList              parameters;
        std::unique_ptr<Epetra_MultiVector> constant_modes;
        settings.set_parameters(parameters,
                                constant_modes,
                                tangent.stored_matrix());
        parameters.set("null space: type", "pre-computed");
        parameters.set("null space: dimension",
                       static_cast<int>(n_rigid_modes));
        parameters.set("null space: vectors", rigid_modes.data());
        multigrid.initialize(tangent.stored_matrix(), parameters);
      }
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
