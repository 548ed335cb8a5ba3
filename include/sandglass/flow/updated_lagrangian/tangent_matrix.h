#ifndef sandglass_flow_updated_lagrangian_tangent_matrix_h
#define sandglass_flow_updated_lagrangian_tangent_matrix_h

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <sandglass/flow/updated_lagrangian/element_grid.h>

#include <Eigen/Core>

#include <vector>

namespace Sandglass
{
  /// How Trilinos has a tangent: as it is, or transposed, which is what KLU
  /// solves faster with.
  enum class TangentStorage
  {
    rows,
    columns
  };

  /**
   * A sparse matrix on the nodes of a ElementGrid that is assembled many times:
   * where the entries of each cell stand is found once. To look for them each
   * time, as TrilinosWrappers::SparseMatrix::add() does, takes three times as
   * long.
   *
   * A rank adds to its own rows only, from its own cells and from ghost cells,
   * so that nothing is exchanged.
   */
  template <int dim>
  class TangentMatrix
  {
  public:
    using Storage = TangentStorage;

    TangentMatrix(const ElementGrid<dim> &grid, const Storage storage);

    TangentMatrix(const TangentMatrix &) = delete;

    const Storage storage;

    void
    set_zero();

    /// Add a cell's matrix, as far as this rank stores it.
    /// @param cell_number  of the cell in ElementGrid::local_cells.
    void
    add(const unsigned int                      cell_number,
        const Eigen::Ref<const Eigen::MatrixXd> cell_matrix);

    /// Add to one entry that this rank stores; slow.
    void
    add(const types::global_dof_index row,
        const types::global_dof_index column,
        const double                  value);

    /// Multiply, whatever the storage.
    void
    vmult(DisplacementVector &result, const DisplacementVector &vector) const;

    /// The matrix as it is stored.
    const TrilinosWrappers::SparseMatrix &
    stored_matrix() const
    {
      return sparse_matrix;
    }

  private:
    /// Where an entry stands in `values`, by its stored row and column in
    /// Trilinos' numbers on this rank; invalid_unsigned_int if this rank hasn't
    /// the row.
    unsigned int
    find_position(const int row, const int column) const;

    TrilinosWrappers::SparseMatrix sparse_matrix;
    const unsigned int             dofs_per_cell;
    /// Trilinos' arrays: beginnings of rows, columns and values of entries.
    int    *row_begins = nullptr, *columns = nullptr;
    double *values = nullptr;
    /// Positions of each local cell's entries, row by row; invalid_unsigned_int
    /// for those that other ranks store.
    std::vector<unsigned int> positions;
  };
} // namespace Sandglass

#endif
