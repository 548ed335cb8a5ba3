#include <deal.II/dofs/dof_tools.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <sandglass/static_stage/tangent_matrix.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <utility>

namespace Sandglass
{
  namespace
  {
    TrilinosWrappers::SparsityPattern
    make_sparsity(const FilledGrid &grid)
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



  TangentMatrix::TangentMatrix(const FilledGrid &grid, const Storage storage)
    : storage(storage)
    , sparse_matrix(make_sparsity(grid))
    , dofs_per_cell(grid.finite_element.n_dofs_per_cell())
  {
    const int status =
      sparse_matrix.trilinos_matrix().ExtractCrsDataPointers(row_begins,
                                                             columns,
                                                             values);
    AssertThrow(status == 0, ExcTrilinosError(status));

    positions.reserve(grid.local_cells.size() * dofs_per_cell * dofs_per_cell);
    std::vector<types::global_dof_index> dofs(dofs_per_cell);
    for (const auto &local_cell : grid.local_cells)
      {
        local_cell.cell->get_dof_indices(dofs);
        for (const auto row : dofs)
          for (const auto column : dofs)
            positions.push_back(grid.owned_dofs.is_element(
                                  storage == Storage::rows ? row : column) ?
                                  find_position(row, column) :
                                  numbers::invalid_unsigned_int);
      }
  }



  unsigned int
  TangentMatrix::find_position(types::global_dof_index row,
                               types::global_dof_index column) const
  {
    if (storage == Storage::columns)
      std::swap(row, column);
    const Epetra_CrsMatrix &crs_matrix = sparse_matrix.trilinos_matrix();
    const int               local_row  = crs_matrix.LRID(static_cast<int>(row));
    Assert(local_row >= 0, ExcInternalError());
    int *const       end = columns + row_begins[local_row + 1];
    const int *const entry =
      std::find(columns + row_begins[local_row],
                end,
                crs_matrix.LCID(static_cast<int>(column)));
    Assert(entry != end, ExcInternalError());
    return entry - columns;
  }



  void
  TangentMatrix::set_zero()
  {
    std::fill(values,
              values + sparse_matrix.trilinos_matrix().NumMyNonzeros(),
              0.);
  }



  void
  TangentMatrix::add(const unsigned int                      cell_number,
                     const Eigen::Ref<const Eigen::MatrixXd> cell_matrix)
  {
    const unsigned int *position =
      &positions[cell_number * dofs_per_cell * dofs_per_cell];
    for (unsigned int i = 0; i < dofs_per_cell; ++i)
      for (unsigned int j = 0; j < dofs_per_cell; ++j, ++position)
        if (*position != numbers::invalid_unsigned_int)
          values[*position] += cell_matrix(i, j);
  }



  void
  TangentMatrix::add(const types::global_dof_index row,
                     const types::global_dof_index column,
                     const double                  value)
  {
    values[find_position(row, column)] += value;
  }



  void
  TangentMatrix::vmult(FilledGrid::Vector       &result,
                       const FilledGrid::Vector &vector) const
  {
    if (storage == Storage::rows)
      sparse_matrix.vmult(result, vector);
    else
      sparse_matrix.Tvmult(result, vector);
  }
} // namespace Sandglass
