#ifndef sandglass_flow_particle_in_cell_mass_matrix_h
#define sandglass_flow_particle_in_cell_mass_matrix_h

#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/solver_cg.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/flow/particle_in_cell/nodal_sums.h>

#include <memory>

namespace Sandglass
{
  /**
   * The mass matrix M_alpha = alpha M + (1 - alpha) M_I of Section 3, where M =
   * S^T M_d S is the consistent one and M_I the lumped one.
   *
   * With alpha = 0 it is diagonal, and nothing is stored. Otherwise each cell
   * keeps its share of it, and systems are solved by conjugate gradients with
   * M_I as the preconditioner: all eigenvalues of M_I^-1 M_alpha lie between 1
   * - alpha and 1, so the number of iterations does not depend on the mesh.
   */
  template <typename Setting>
  class MassMatrix
  {
  public:
    static constexpr unsigned int n_nodes = Setting::nodes_per_cell;
    static constexpr int          dim     = Setting::dim;

    using Geometry = CellGeometry<Setting::cell_type>;
    using Blocks   = ParticleBlocks<typename Setting::Layout>;
    using NodalSum = Sandglass::NodalSum<dim>;
    using Vector   = typename NodalField<dim>::Vector;
    using Sums     = NodalSumField<dim>;

    /// @param consistent_share  alpha, 0 <= alpha < 1.
    MassMatrix(const Utilities::MPI::Partitioner &nodes,
               const Geometry                    &geometry,
               const double                       consistent_share)
      : consistent_share(consistent_share)
      , nodes(nodes)
      , geometry(geometry)
    {
      if (!is_lumped())
        workspace = std::make_unique<Workspace>(nodes);
    }

    bool
    is_lumped() const
    {
      return consistent_share == 0.;
    }

    /// Take the masses from the particles' sums.
    void
    assemble(const Blocks             &blocks,
             const NodalSums<Setting> &cells,
             const Sums               &sums)
    {
      if (is_lumped())
        return;
      workspace->cells.clear();
      for_each_filled_cell(blocks, [&](const unsigned int cell) {
        workspace->cells.push_back(
          cell_mass(geometry.nodes(cell), cells[cell]));
      });
      Vector &inverse = workspace->inverse_lumped_mass.get_vector();
      for (unsigned int node = 0; node < nodes.locally_owned_size(); ++node)
        for (unsigned int d = 0; d < dim; ++d)
          inverse.local_element(dim * node + d) =
            inverse_or_zero(sums.at(node)[NodalSum::mass]);
    }

    /// field = M_I^-1 field, 0 at nodes without mass; ghosts are not updated.
    void
    solve_lumped(const Sums &sums, NodalField<dim> &field) const
    {
      for (unsigned int node = 0; node < nodes.locally_owned_size(); ++node)
        for (unsigned int d = 0; d < dim; ++d)
          field.at(node)[d] *= inverse_or_zero(sums.at(node)[NodalSum::mass]);
    }

    /// field = M_alpha^-1 field. Only for a consistent matrix. Collective.
    /// Throws RunError.
    void
    solve(NodalField<dim> &field)
    {
      workspace->right_hand_side = field.vector();
      run_solver([](NodalField<dim> &) {}, field);
    }

    /**
     * Turn the lumped matrix's solution, field = M_I^-1 f, into that of
     * M_alpha, but keep it in the directions in which nodes are held. Only for
     * a consistent matrix. Collective. Throws RunError.
     *
     * @param release  sets what a nodal field has in these directions to zero.
     * @return M_alpha field - f, the forces that hold the nodes beyond those in
     *         f, valid until the next call.
     */
    template <typename Release>
    const NodalField<dim> &
    solve_held(const Sums &sums, const Release &release, NodalField<dim> &field)
    {
      NodalField<dim> &residual = workspace->residual;
      compute_residual(sums, field, residual);
      release(residual);
      workspace->right_hand_side = residual.vector();
      run_solver(release, workspace->correction);
      field.vector() += workspace->correction.vector();
      compute_residual(sums, field, residual);
      residual.vector() *= -1.;
      return residual;
    }

    /// alpha
    const double consistent_share;

  private:
    /// One cell's share of M_alpha, in kg.
    struct CellMass
    {
      std::array<unsigned int, n_nodes>                nodes;
      std::array<std::array<double, n_nodes>, n_nodes> matrix;
    };

    /// What only a consistent matrix needs.
    struct Workspace
    {
      explicit Workspace(const Utilities::MPI::Partitioner &nodes)
        : input(nodes)
        , product(nodes)
        , residual(nodes)
        , correction(nodes)
        , right_hand_side(product.vector())
        , inverse_lumped_mass(product.vector())
      {}

      std::vector<CellMass>       cells;
      NodalField<dim>             input;
      NodalField<dim>             product;
      NodalField<dim>             residual;
      NodalField<dim>             correction;
      Vector                      right_hand_side;
      DiagonalMatrix<Vector>      inverse_lumped_mass;
      GrowingVectorMemory<Vector> memory;
    };

    /// What deal.II's solver multiplies by.
    template <typename Release>
    struct FreeDirections
    {
      void
      vmult(Vector &destination, const Vector &source) const
      {
        mass_matrix.multiply(source);
        release(mass_matrix.workspace->product);
        destination = mass_matrix.workspace->product.vector();
      }

      MassMatrix    &mass_matrix;
      const Release &release;
    };

    static double
    inverse_or_zero(const double mass)
    {
      return mass > 0. ? 1. / mass : 0.;
    }

    CellMass
    cell_mass(const std::array<unsigned int, n_nodes> &cell_nodes,
              const CellSums<Setting, double>         &sums) const
    {
      const auto lumped_masses = sums.lumped_masses();
      CellMass   cell{cell_nodes, {}};
      for (unsigned int i = 0; i < n_nodes; ++i)
        {
          for (unsigned int j = 0; j < n_nodes; ++j)
            cell.matrix[i][j] = consistent_share * sums.mass_entry(i, j);
          cell.matrix[i][i] += (1. - consistent_share) * lumped_masses[i];
        }
      return cell;
    }

    /// workspace->product = M_alpha source
    void
    multiply(const Vector &source)
    {
      NodalField<dim> &product = workspace->product;
      NodalField<dim> &input   = workspace->input;
      input.vector()           = source;
      input.update_ghosts();
      product.start_sum();
      for (const CellMass &cell : workspace->cells)
        {
          const auto               values = gather(input, cell.nodes);
          CellValues<dim, n_nodes> products{};
          for (unsigned int i = 0; i < n_nodes; ++i)
            for (unsigned int j = 0; j < n_nodes; ++j)
              for (unsigned int d = 0; d < dim; ++d)
                products[i][d] += cell.matrix[i][j] * values[j][d];
          scatter(products, cell.nodes, product);
        }
      product.finish_sum();
    }

    /// residual = (M_I - M_alpha) field
    void
    compute_residual(const Sums      &sums,
                     NodalField<dim> &field,
                     NodalField<dim> &residual)
    {
      multiply(field.vector());
      for (unsigned int node = 0; node < nodes.locally_owned_size(); ++node)
        for (unsigned int d = 0; d < dim; ++d)
          residual.at(node)[d] =
            sums.at(node)[NodalSum::mass] * field.at(node)[d] -
            workspace->product.at(node)[d];
    }

    /// solution, starting from 0, for workspace->right_hand_side.
    template <typename Release>
    void
    run_solver(const Release &release, NodalField<dim> &solution)
    {
      constexpr double       reduction      = 1e-10;
      constexpr unsigned int max_iterations = 1000;
      solution.start_sum();
      ReductionControl control(max_iterations, 1e-300, reduction);
      SolverCG<Vector> solver(control, workspace->memory);
      try
        {
          solver.solve(FreeDirections<Release>{*this, release},
                       solution.vector(),
                       workspace->right_hand_side,
                       workspace->inverse_lumped_mass);
        }
      catch (const SolverControl::NoConvergence &failure)
        {
          throw RunError(
            "The system of the consistent mass matrix did not converge in " +
            std::to_string(failure.last_step) +
            " iterations. Try a smaller Particle stage/Consistent mass share.");
        }
    }

    const Utilities::MPI::Partitioner &nodes;
    const Geometry                    &geometry;
    std::unique_ptr<Workspace>         workspace;
  };
} // namespace Sandglass

#endif
