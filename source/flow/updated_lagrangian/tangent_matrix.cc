#include <deal.II/dofs/dof_tools.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/updated_lagrangian/tangent_matrix.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <utility>

namespace Sandglass
{
  namespace
  {
    template <int dim>
    TrilinosWrappers::SparsityPattern
    make_sparsity(const ElementGrid<dim> &grid)
    {
      TrilinosWrappers::SparsityPattern sparsity(
        grid.owned_dofs, grid.triangulation.get_communicator());
      DoFTools::make_sparsity_pattern(
        grid.dof_handler,
        sparsity,
        AffineConstraints<double>(),
        true,
        grid.triangulation.locally_owned_subdomain());
      sparsity.compress();
      return sparsity;
    }
  } // namespace



  template <int dim>
  TangentMatrix<dim>::TangentMatrix(const ElementGrid<dim> &grid,
                                    const Storage           storage)
    : storage(storage)
    , sparse_matrix(make_sparsity(grid))
    , dofs_per_cell(grid.finite_element.n_dofs_per_cell())
  {
    const int status =
      sparse_matrix.trilinos_matrix().ExtractCrsDataPointers(row_begins,
                                                             columns,
                                                             values);
    AssertThrow(status == 0, ExcTrilinosError(status));

    const Epetra_CrsMatrix &matrix = sparse_matrix.trilinos_matrix();
    positions.reserve(grid.local_cells.size() * dofs_per_cell * dofs_per_cell);
    std::vector<types::global_dof_index> dofs(dofs_per_cell);
    std::vector<int>                     rows_of_cell(dofs_per_cell),
      columns_of_cell(dofs_per_cell);
    for (const auto &local_cell : grid.local_cells)
      {
        local_cell.cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs_per_cell; ++i)
          {
            rows_of_cell[i]    = matrix.LRID(static_cast<int>(dofs[i]));
            columns_of_cell[i] = matrix.LCID(static_cast<int>(dofs[i]));
          }
        for (unsigned int i = 0; i < dofs_per_cell; ++i)
          for (unsigned int j = 0; j < dofs_per_cell; ++j)
            positions.push_back(
              storage == Storage::rows ?
                find_position(rows_of_cell[i], columns_of_cell[j]) :
                find_position(rows_of_cell[j], columns_of_cell[i]));
      }
  }



  template <int dim>
  unsigned int
  TangentMatrix<dim>::find_position(const int row, const int column) const
  {
    if (row < 0)
      return numbers::invalid_unsigned_int;
    int *const       end   = columns + row_begins[row + 1];
    const int *const entry = std::find(columns + row_begins[row], end, column);
    Assert(entry != end, ExcInternalError());
    return entry - columns;
  }



  template <int dim>
  void
  TangentMatrix<dim>::set_zero()
  {
    std::fill(values,
              values + sparse_matrix.trilinos_matrix().NumMyNonzeros(),
              0.);
  }



  template <int dim>
  void
  TangentMatrix<dim>::add(const unsigned int                      cell_number,
                          const Eigen::Ref<const Eigen::MatrixXd> cell_matrix)
  {
    const unsigned int *position =
      &positions[cell_number * dofs_per_cell * dofs_per_cell];
    for (unsigned int i = 0; i < dofs_per_cell; ++i)
      for (unsigned int j = 0; j < dofs_per_cell; ++j, ++position)
        if (*position != numbers::invalid_unsigned_int)
          values[*position] += cell_matrix(i, j);
  }



  template <int dim>
  void
  TangentMatrix<dim>::add(const types::global_dof_index row,
                          const types::global_dof_index column,
                          const double                  value)
  {
    const Epetra_CrsMatrix &matrix         = sparse_matrix.trilinos_matrix();
    const auto [stored_row, stored_column] = storage == Storage::rows ?
                                               std::pair(row, column) :
                                               std::pair(column, row);
    const unsigned int position =
      find_position(matrix.LRID(static_cast<int>(stored_row)),
                    matrix.LCID(static_cast<int>(stored_column)));
    Assert(position != numbers::invalid_unsigned_int, ExcInternalError());
    values[position] += value;
  }



  template <int dim>
  void
  TangentMatrix<dim>::vmult(DisplacementVector       &result,
                            const DisplacementVector &vector) const
  {
    if (storage == Storage::rows)
      sparse_matrix.vmult(result, vector);
    else
      sparse_matrix.Tvmult(result, vector);
  }



#define INSTANTIATE(dim) template class TangentMatrix<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
