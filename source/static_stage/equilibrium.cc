#include <deal.II/base/numbers.h>

#include <sandglass/static_stage/equilibrium.h>

namespace Sandglass
{
  namespace
  {
    Eigen::Matrix2d
    to_eigen(const Tensor<2, dim> &tensor)
    {
      Eigen::Matrix2d matrix;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          matrix(i, j) = tensor[i][j];
      return matrix;
    }



    template <typename CellVector>
    CellVector
    cell_values(const std::vector<types::global_dof_index> &dofs,
                const FilledGrid::Vector                   &vector)
    {
      CellVector values(dofs.size());
      for (unsigned int i = 0; i < dofs.size(); ++i)
        values[i] = vector[dofs[i]];
      return values;
    }
  } // namespace



  Equilibrium::Equilibrium(const FilledGrid     &grid,
                           const Formulation     formulation,
                           const DruckerPrager  &material,
                           const double          density,
                           const Tensor<1, dim> &gravity)
    : Equilibrium(grid,
                  formulation,
                  material,
                  density,
                  [gravity](const Point<dim> &) { return gravity; })
  {}



  Equilibrium::Equilibrium(const FilledGrid    &grid,
                           const Formulation    formulation,
                           const DruckerPrager &material,
                           const double         density,
                           const BodyForce     &body_force)
    : grid(grid)
    , formulation(formulation)
    , material(material)
    , points(grid.triangulation.n_active_cells() * grid.quadrature.size())
    , gradient_operators(points.size())
    , volumes(points.size())
    , nodal_weight(grid.make_vector())
  {
    start_step(grid.make_vector()); // undeformed
    assemble_weight(density, body_force);
  }



  template <typename Work>
  void
  Equilibrium::for_each_cell(const Work &work) const
  {
    std::vector<types::global_dof_index> dofs(
      grid.finite_element.n_dofs_per_cell());
    for (const auto &cell : grid.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(dofs);
          work(cell, dofs);
        }
  }



  void
  Equilibrium::assemble_weight(const double     density,
                               const BodyForce &body_force)
  {
    FEValues<dim> fe_values(grid.mapping,
                            grid.finite_element,
                            grid.quadrature,
                            update_values | update_quadrature_points);
    nodal_weight.zero_out_ghost_values();
    for_each_cell([&](const auto &cell, const auto &dofs) {
      fe_values.reinit(cell);
      for (const unsigned int q : fe_values.quadrature_point_indices())
        {
          const double mass = density * volumes[grid.point_index(*cell, q)];
          const Tensor<1, dim> acceleration =
            body_force(fe_values.quadrature_point(q));
          for (const unsigned int i : fe_values.dof_indices())
            nodal_weight[dofs[i]] += mass * fe_values.shape_value(i, q) *
                                     acceleration[grid.component(i)];
        }
    });
    nodal_weight.compress(VectorOperation::add);
    nodal_weight.update_ghost_values();
  }



  void
  Equilibrium::start_step(const Vector &displacement)
  {
    FEValues<dim> fe_values(grid.mapping,
                            grid.finite_element,
                            grid.quadrature,
                            update_values | update_gradients |
                              update_quadrature_points | update_JxW_values);
    for_each_cell([&](const auto &cell, const auto &dofs) {
      fe_values.reinit(cell);
      const auto u = cell_values<CellVector>(dofs, displacement);
      for (const unsigned int q : fe_values.quadrature_point_indices())
        start_step(fe_values, q, u, grid.point_index(*cell, q));
    });
  }



  void
  Equilibrium::start_step(const FEValues<dim> &fe_values,
                          const unsigned int   q,
                          const CellVector    &displacement,
                          const unsigned int   index)
  {
    // Deformation since the unloaded state; x is the radius if axisymmetric.
    Tensor<2, dim> F = unit_symmetric_tensor<dim>();
    double         x = fe_values.quadrature_point(q)[0];
    for (const unsigned int i : fe_values.dof_indices())
      {
        const unsigned int c = grid.component(i);
        F[c] += displacement[i] * fe_values.shape_grad(i, q);
        if (c == 0)
          x += displacement[i] * fe_values.shape_value(i, q);
      }
    const bool has_hoop_strain = formulation == Formulation::axisymmetric;
    volumes[index]             = fe_values.JxW(q) * determinant(F) *
                     (has_hoop_strain ? 2. * numbers::PI * x : 1.);

    const Tensor<2, dim> F_inverse = invert(F);
    GradientOperator    &B         = gradient_operators[index];
    B.setZero(5, fe_values.dofs_per_cell);
    for (const unsigned int i : fe_values.dof_indices())
      {
        const unsigned int   c        = grid.component(i);
        const Tensor<1, dim> gradient = fe_values.shape_grad(i, q) * F_inverse;
        for (unsigned int d = 0; d < dim; ++d)
          B(dim * c + d, i) = gradient[d];
        if (c == 0 && has_hoop_strain)
          B(GradientComponent::hoop, i) = fe_values.shape_value(i, q) / x;
      }

    MaterialPoint &point      = points[index];
    point.stress_before       = point.stress;
    point.volume_ratio_before = point.volume_ratio;
  }



  void
  Equilibrium::update_stress(const CellVector  &increment,
                             const unsigned int index)
  {
    MaterialPoint &point = points[index];
    point.gradient       = gradient_operators[index] * increment;
    point.trial_stress = IncrementalResponse::trial_stress(material.elasticity,
                                                           point.stress_before,
                                                           point.gradient);
    point.stress       = point.trial_stress;
    material.project(point.stress);
    point.volume_ratio = point.volume_ratio_before *
                         IncrementalResponse::volume_ratio(point.gradient);
  }



  void
  Equilibrium::evaluate_forces(const Vector &increment,
                               const double  load_share,
                               Vector       &forces)
  {
    forces.zero_out_ghost_values();
    forces = 0.;
    for_each_cell([&](const auto &cell, const auto &dofs) {
      const auto du         = cell_values<CellVector>(dofs, increment);
      CellVector cell_force = CellVector::Zero(dofs.size());
      for (unsigned int q = 0; q < grid.quadrature.size(); ++q)
        {
          const unsigned int index = grid.point_index(*cell, q);
          update_stress(du, index);
          cell_force +=
            volumes[index] * gradient_operators[index].transpose() *
            IncrementalResponse::piola_stress(points[index].stress,
                                              points[index].gradient);
        }
      for (unsigned int i = 0; i < dofs.size(); ++i)
        forces[dofs[i]] += cell_force[i];
    });
    forces.compress(VectorOperation::add);
    forces.add(-load_share, nodal_weight);
    forces.update_ghost_values();
  }



  Equilibrium::CellMatrix
  Equilibrium::cell_tangent(const CellIterator &cell,
                            const WallContact  &contact,
                            const double        elastic_share) const
  {
    const unsigned int n_dofs = grid.finite_element.n_dofs_per_cell();
    CellMatrix         result = CellMatrix::Zero(n_dofs, n_dofs);
    for (unsigned int q = 0; q < grid.quadrature.size(); ++q)
      {
        const unsigned int      index = grid.point_index(*cell, q);
        const MaterialPoint    &point = points[index];
        const GradientOperator &B     = gradient_operators[index];
        result += volumes[index] * B.transpose() *
                  IncrementalResponse::tangent(
                    material.elasticity,
                    point.stress_before,
                    point.stress,
                    point.gradient,
                    IncrementalResponse::stabilized_projection_derivative(
                      material, point.trial_stress, elastic_share)) *
                  B;
      }
    for (const unsigned int v : cell->vertex_indices())
      if (const auto *equations = contact.equations_at(cell->vertex_index(v)))
        result.middleRows<dim>(dim * v) = (to_eigen(equations->force_operator) *
                                           result.middleRows<dim>(dim * v))
                                            .eval();
    return result;
  }



  void
  Equilibrium::assemble_tangent(const WallContact              &contact,
                                const double                    elastic_share,
                                TrilinosWrappers::SparseMatrix &matrix) const
  {
    matrix                    = 0.;
    const unsigned int n_dofs = grid.finite_element.n_dofs_per_cell();
    FullMatrix<double> block(n_dofs, n_dofs);
    for_each_cell([&](const auto &cell, const auto &dofs) {
      const CellMatrix tangent = cell_tangent(cell, contact, elastic_share);
      for (unsigned int i = 0; i < n_dofs; ++i)
        for (unsigned int j = 0; j < n_dofs; ++j)
          block(i, j) = tangent(i, j);
      constexpr bool leave_out_zeros = false; // to look for them costs more
      matrix.add(dofs, block, leave_out_zeros);
    });
    contact.add_stiffness([&matrix](const auto i, const auto j, const auto a) {
      matrix.add(i, j, a);
    });
    matrix.compress(VectorOperation::add);
  }
} // namespace Sandglass
