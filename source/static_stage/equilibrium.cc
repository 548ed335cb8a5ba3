#include <deal.II/base/numbers.h>

#include <deal.II/fe/fe_values.h>

#include <sandglass/static_stage/equilibrium.h>

namespace Sandglass
{
  namespace
  {
    /**
     * Share of the elastic stiffness that separated points keep in the tangent
     * (not in the forces). Without it, a node all of whose cells are separated
     * would have an equation of zeros.
     */
    constexpr double separated_stiffness = 1e-3;



    Eigen::Matrix2d
    to_eigen(const Tensor<2, dim> &tensor)
    {
      Eigen::Matrix2d matrix;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          matrix(i, j) = tensor[i][j];
      return matrix;
    }



    /// Keeps the volumetric part and scales the deviatoric part by `ratio`.
    Eigen::Matrix4d
    scale_deviator(const double ratio)
    {
      const SymmetricTensor4 identity(1., 1., 1., 0.);
      return ratio * Eigen::Matrix4d::Identity() +
             (1. - ratio) / 3. * identity * identity.transpose();
    }



    /// Derivative of the projection as Newton's method uses it.
    Eigen::Matrix4d
    projection_tangent(const DruckerPrager    &material,
                       const SymmetricTensor4 &trial_stress,
                       const double            elastic_share)
    {
      // At the cone's apex the derivative doesn't exist. Confined material
      // comes from there along the yield surface rather than elastically.
      if (trial_stress.isZero(0.))
        return scale_deviator(
          std::min(1.,
                   material.yield_slope * material.elasticity.bulk_modulus() /
                     (2. * material.elasticity.shear_modulus)));
      if (pressure(trial_stress) <= 0.)
        return (separated_stiffness +
                (1. - separated_stiffness) * elastic_share) *
               Eigen::Matrix4d::Identity();
      return (1. - elastic_share) *
               material.projection_derivative(trial_stress) +
             elastic_share * Eigen::Matrix4d::Identity();
    }
  } // namespace



  Equilibrium::Equilibrium(const FilledGrid     &grid,
                           const Formulation     formulation,
                           const DruckerPrager  &material,
                           const double          density,
                           const Tensor<1, dim> &gravity)
    : grid(grid)
    , formulation(formulation)
    , material(material)
    , points(grid.triangulation.n_active_cells() * grid.quadrature.size())
    , gradient_operators(points.size())
    , volumes(points.size())
    , nodal_weight(grid.make_vector())
  {
    start_step(grid.make_vector());

    FEValues<dim> fe_values(grid.mapping,
                            grid.finite_element,
                            grid.quadrature,
                            update_values);
    for (const auto &cell : grid.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          fe_values.reinit(cell);
          std::vector<types::global_dof_index> dofs(
            grid.finite_element.n_dofs_per_cell());
          cell->get_dof_indices(dofs);
          const unsigned int first =
            cell->active_cell_index() * grid.quadrature.size();
          for (unsigned int i = 0; i < dofs.size(); ++i)
            for (unsigned int q = 0; q < grid.quadrature.size(); ++q)
              nodal_weight[dofs[i]] +=
                density * volumes[first + q] * fe_values.shape_value(i, q) *
                gravity[grid.finite_element.system_to_component_index(i).first];
        }
    nodal_weight.compress(VectorOperation::add);
  }



  Equilibrium::CellVector
  Equilibrium::cell_values(const DoFHandler<dim>::active_cell_iterator &cell,
                           const Vector &vector) const
  {
    std::vector<types::global_dof_index> dofs(
      grid.finite_element.n_dofs_per_cell());
    cell->get_dof_indices(dofs);
    CellVector values(dofs.size());
    for (unsigned int i = 0; i < dofs.size(); ++i)
      values[i] = vector[dofs[i]];
    return values;
  }



  void
  Equilibrium::start_step(const Vector &displacement)
  {
    const bool    has_hoop_strain = formulation == Formulation::axisymmetric;
    FEValues<dim> fe_values(grid.mapping,
                            grid.finite_element,
                            grid.quadrature,
                            update_values | update_gradients |
                              update_quadrature_points | update_JxW_values);
    for (const auto &cell : grid.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          fe_values.reinit(cell);
          const CellVector   u      = cell_values(cell, displacement);
          const unsigned int n_dofs = fe_values.dofs_per_cell;
          for (const unsigned int q : fe_values.quadrature_point_indices())
            {
              const unsigned int index =
                cell->active_cell_index() * grid.quadrature.size() + q;
              Tensor<2, dim> F = unit_symmetric_tensor<dim>();
              double         x = fe_values.quadrature_point(q)[0];
              for (unsigned int i = 0; i < n_dofs; ++i)
                {
                  const unsigned int c =
                    grid.finite_element.system_to_component_index(i).first;
                  F[c] += u[i] * fe_values.shape_grad(i, q);
                  if (c == 0)
                    x += u[i] * fe_values.shape_value(i, q);
                }
              const Tensor<2, dim> F_inverse = invert(F);

              GradientOperator &B = gradient_operators[index];
              B.setZero(5, n_dofs);
              for (unsigned int i = 0; i < n_dofs; ++i)
                {
                  const unsigned int c =
                    grid.finite_element.system_to_component_index(i).first;
                  const Tensor<1, dim> gradient =
                    fe_values.shape_grad(i, q) * F_inverse;
                  B(2 * c, i)     = gradient[0];
                  B(2 * c + 1, i) = gradient[1];
                  if (c == 0 && has_hoop_strain)
                    B(GradientComponent::hoop, i) =
                      fe_values.shape_value(i, q) / x;
                }
              volumes[index] = fe_values.JxW(q) * determinant(F) *
                               (has_hoop_strain ? 2. * numbers::PI * x : 1.);

              MaterialPoint &point      = points[index];
              point.stress_before       = point.stress;
              point.volume_ratio_before = point.volume_ratio;
            }
        }
  }



  void
  Equilibrium::evaluate_forces(const Vector &increment,
                               const double  load_share,
                               Vector       &forces)
  {
    forces.zero_out_ghost_values();
    forces = 0.;
    std::vector<types::global_dof_index> dofs(
      grid.finite_element.n_dofs_per_cell());
    double dissipation = 0.;
    for (const auto &cell : grid.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const CellVector du         = cell_values(cell, increment);
          CellVector       cell_force = CellVector::Zero(du.size());
          for (unsigned int q = 0; q < grid.quadrature.size(); ++q)
            {
              const unsigned int index =
                cell->active_cell_index() * grid.quadrature.size() + q;
              MaterialPoint &point = points[index];
              point.gradient       = gradient_operators[index] * du;
              point.trial_stress =
                IncrementalResponse::trial_stress(material.elasticity,
                                                  point.stress_before,
                                                  point.gradient);
              point.stress = point.trial_stress;
              material.project(point.stress, dissipation);
              point.volume_ratio =
                point.volume_ratio_before *
                IncrementalResponse::volume_ratio(point.gradient);
              cell_force +=
                volumes[index] * gradient_operators[index].transpose() *
                IncrementalResponse::piola_stress(point.stress, point.gradient);
            }
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            forces[dofs[i]] += cell_force[i];
        }
    forces.compress(VectorOperation::add);
    forces.add(-load_share, nodal_weight);
    forces.update_ghost_values();
  }



  void
  Equilibrium::assemble_tangent(const WallContact              &contact,
                                const double                    elastic_share,
                                TrilinosWrappers::SparseMatrix &matrix) const
  {
    matrix                    = 0.;
    const unsigned int n_dofs = grid.finite_element.n_dofs_per_cell();
    std::vector<types::global_dof_index> dofs(n_dofs);
    FullMatrix<double>                   block(n_dofs, n_dofs);
    for (const auto &cell : grid.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          CellMatrix cell_matrix = CellMatrix::Zero(n_dofs, n_dofs);
          for (unsigned int q = 0; q < grid.quadrature.size(); ++q)
            {
              const unsigned int index =
                cell->active_cell_index() * grid.quadrature.size() + q;
              const MaterialPoint    &point = points[index];
              const GradientOperator &B     = gradient_operators[index];
              cell_matrix +=
                volumes[index] * B.transpose() *
                IncrementalResponse::tangent(
                  material.elasticity,
                  point.stress_before,
                  point.stress,
                  point.gradient,
                  projection_tangent(material,
                                     point.trial_stress,
                                     elastic_share)) *
                B;
            }
          for (const unsigned int v : cell->vertex_indices())
            if (const auto *equations =
                  contact.equations_at(cell->vertex_index(v)))
              cell_matrix.middleRows<dim>(dim * v) =
                (to_eigen(equations->force_operator) *
                 cell_matrix.middleRows<dim>(dim * v))
                  .eval();
          for (unsigned int i = 0; i < n_dofs; ++i)
            for (unsigned int j = 0; j < n_dofs; ++j)
              block(i, j) = cell_matrix(i, j);
          cell->get_dof_indices(dofs);
          matrix.add(dofs, block);
        }
    contact.add_stiffness([&matrix](const auto i, const auto j, const auto a) {
      matrix.add(i, j, a);
    });
    matrix.compress(VectorOperation::add);
  }
} // namespace Sandglass
