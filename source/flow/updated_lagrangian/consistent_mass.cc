#include <deal.II/base/mpi.h>

#include <deal.II/fe/fe_values.h>

#include <sandglass/choices/choose_kinematics.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/updated_lagrangian/consistent_mass.h>

namespace Sandglass
{
  template <int dim>
  ConsistentMass<dim>::ConsistentMass(const ElementGrid<dim> &grid,
                                      const Formulation       formulation,
                                      const Density          &density)
    : grid(grid)
    , n_nodes(grid.finite_element.n_dofs_per_cell() / dim)
    , masses(grid.local_cells.size() * n_nodes * n_nodes, 0.)
  {
    FEValues<dim> fe_values(grid.mapping,
                            grid.finite_element,
                            grid.mass_quadrature,
                            update_values | update_quadrature_points |
                              update_JxW_values);
    const bool    is_spread = grid.mass_quadrature.size() == 1;
    auto          entry     = masses.begin();
    for (const auto &local_cell : grid.local_cells)
      {
        fe_values.reinit(local_cell.cell);
        for (unsigned int i = 0; i < n_nodes; ++i)
          for (unsigned int j = 0; j < n_nodes; ++j, ++entry)
            for (const unsigned int q : fe_values.quadrature_point_indices())
              {
                const Point<dim> &position = fe_values.quadrature_point(q);
                // The integral of two linear shape functions over a simplex of
                // unit volume
                const double share =
                  is_spread ? (i == j ? 2. : 1.) / ((dim + 1.) * (dim + 2.)) :
                              fe_values.shape_value(dim * i, q) *
                                fe_values.shape_value(dim * j, q);
                *entry += density(position) * fe_values.JxW(q) *
                          measure<dim>(formulation, position) * share;
              }
      }
  }



  template <int dim>
  ConsistentMass<dim>::ConsistentMass(const ElementGrid<dim>    &grid,
                                      const std::vector<double> &point_masses)
    : grid(grid)
    , n_nodes(grid.finite_element.n_dofs_per_cell() / dim)
    , masses(grid.local_cells.size() * n_nodes * n_nodes, 0.)
  {
    const Quadrature<dim> &quadrature = grid.mass_quadrature;
    const auto            &element    = grid.finite_element.base_element(0);
    AssertDimension(point_masses.size(),
                    grid.local_cells.size() * quadrature.size());
    const bool is_spread = quadrature.size() == 1;
    auto       entry     = masses.begin();
    for (unsigned int n = 0; n < grid.local_cells.size(); ++n)
      for (unsigned int i = 0; i < n_nodes; ++i)
        for (unsigned int j = 0; j < n_nodes; ++j, ++entry)
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            *entry +=
              point_masses[n * quadrature.size() + q] *
              (is_spread ? (i == j ? 2. : 1.) / ((dim + 1.) * (dim + 2.)) :
                           element.shape_value(i, quadrature.point(q)) *
                             element.shape_value(j, quadrature.point(q)));
  }



  template <int dim>
  void
  ConsistentMass<dim>::add_forces(const Vector &acceleration,
                                  Vector       &forces) const
  {
    const unsigned int n_owned = grid.n_owned_dofs();
    for (unsigned int n = 0; n < grid.local_cells.size(); ++n)
      {
        const auto &dofs = grid.local_cells[n].dofs;
        for (unsigned int i = 0; i < n_nodes; ++i)
          if (dofs[dim * i] < n_owned)
            for (unsigned int d = 0; d < dim; ++d)
              {
                double force = 0.;
                for (unsigned int j = 0; j < n_nodes; ++j)
                  force += mass(n, i, j) *
                           acceleration.local_element(dofs[dim * j + d]);
                forces.local_element(dofs[dim * i + d]) += force;
              }
      }
  }



  template <int dim>
  void
  ConsistentMass<dim>::add_tangent(const double                factor,
                                   const NodeConstraints<dim> &constraints,
                                   TangentMatrix<dim>         &tangent) const
  {
    Eigen::MatrixXd cell_matrix(dim * n_nodes, dim * n_nodes);
    for (unsigned int n = 0; n < grid.local_cells.size(); ++n)
      {
        cell_matrix.setZero();
        for (unsigned int i = 0; i < n_nodes; ++i)
          for (unsigned int j = 0; j < n_nodes; ++j)
            for (unsigned int d = 0; d < dim; ++d)
              cell_matrix(dim * i + d, dim * j + d) = factor * mass(n, i, j);
        constraints.replace_rows(grid.local_cells[n], cell_matrix);
        tangent.add(n, cell_matrix);
      }
  }



  template <int dim>
  double
  ConsistentMass<dim>::kinetic_energy(const Vector &velocity) const
  {
    Vector momentum(velocity);
    momentum.zero_out_ghost_values();
    momentum = 0.;
    add_forces(velocity, momentum);
    return 0.5 * (momentum * velocity);
  }



  template <int dim>
  double
  ConsistentMass<dim>::total() const
  {
    double sum = 0.;
    for (unsigned int n = 0; n < grid.local_cells.size(); ++n)
      if (grid.local_cells[n].cell->is_locally_owned())
        for (unsigned int i = 0; i < n_nodes; ++i)
          for (unsigned int j = 0; j < n_nodes; ++j)
            sum += mass(n, i, j);
    return Utilities::MPI::sum(sum, grid.triangulation.get_communicator());
  }



#define INSTANTIATE(dim) template class ConsistentMass<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
