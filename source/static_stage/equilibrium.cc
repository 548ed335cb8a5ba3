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
    , material(material)
    , points(grid.triangulation.n_active_cells() * grid.quadrature.size())
    , gradient_operators(points.size())
    , volumes(points.size())
    , nodal_weight(grid.make_vector())
  {
    set_up(formulation, density, body_force);
  }



  void
  Equilibrium::add_to(const FilledGrid::LocalCell            &local_cell,
                      const Eigen::Ref<const Eigen::VectorXd> values,
                      Vector                                 &vector) const
  {
    const unsigned int n_owned = grid.n_owned_dofs();
    for (unsigned int i = 0; i < values.size(); ++i)
      if (local_cell.dofs[i] < n_owned)
        vector.local_element(local_cell.dofs[i]) += values[i];
  }



  void
  Equilibrium::set_up(const Formulation formulation,
                      const double      density,
                      const BodyForce  &body_force)
  {
    FEValues<dim> fe_values(grid.mapping,
                            grid.finite_element,
                            grid.quadrature,
                            update_values | update_gradients |
                              update_quadrature_points | update_JxW_values);
    nodal_weight.zero_out_ghost_values();
    for (const auto &local_cell : grid.local_cells)
      {
        fe_values.reinit(local_cell.cell);
        Eigen::VectorXd cell_weight =
          Eigen::VectorXd::Zero(fe_values.dofs_per_cell);
        for (const unsigned int q : fe_values.quadrature_point_indices())
          {
            const unsigned int index = grid.point_index(*local_cell.cell, q);
            set_up_point(fe_values, q, formulation, index);
            const Tensor<1, dim> force =
              density * volumes[index] *
              body_force(fe_values.quadrature_point(q));
            for (const unsigned int i : fe_values.dof_indices())
              cell_weight[i] +=
                fe_values.shape_value(i, q) * force[grid.component(i)];
          }
        add_to(local_cell, cell_weight, nodal_weight);
      }
    nodal_weight.update_ghost_values();
  }



  void
  Equilibrium::set_up_point(const FEValues<dim> &fe_values,
                            const unsigned int   q,
                            const Formulation    formulation,
                            const unsigned int   index)
  {
    const bool   has_hoop_strain = formulation == Formulation::axisymmetric;
    const double radius          = fe_values.quadrature_point(q)[0];
    volumes[index] =
      fe_values.JxW(q) * (has_hoop_strain ? 2. * numbers::PI * radius : 1.);

    for (const unsigned int i : fe_values.dof_indices())
      if (grid.component(i) == 0)
        {
          const Tensor<1, dim> gradient = fe_values.shape_grad(i, q);
          gradient_operators[index].set_node(
            i / dim,
            {gradient[0], gradient[1]},
            has_hoop_strain ? fe_values.shape_value(i, q) / radius : 0.);
        }
  }



  void
  Equilibrium::start_step()
  {
    for (const auto &local_cell : grid.local_cells)
      for (unsigned int q = 0; q < grid.quadrature.size(); ++q)
        start_step(grid.point_index(*local_cell.cell, q));
  }



  void
  Equilibrium::start_step(const unsigned int index)
  {
    MaterialPoint &point = points[index];
    volumes[index] *= IncrementalResponse::volume_ratio(point.gradient);
    gradient_operators[index].move_reference(point.gradient);

    point.gradient.setZero();
    point.stress_before       = point.stress;
    point.volume_ratio_before = point.volume_ratio;
  }



  template <int n_dofs>
  void
  Equilibrium::update_stress(const Eigen::Matrix<double, n_dofs, 1> &increment,
                             const unsigned int                      index)
  {
    MaterialPoint &point = points[index];
    point.gradient     = gradient_operators[index].gradient<n_dofs>(increment);
    point.trial_stress = IncrementalResponse::trial_stress(material.elasticity,
                                                           point.stress_before,
                                                           point.gradient);
    point.stress       = point.trial_stress;
    material.project(point.stress);
    point.volume_ratio = point.volume_ratio_before *
                         IncrementalResponse::volume_ratio(point.gradient);
  }



  template <int n_dofs>
  void
  Equilibrium::add_internal_forces(const Vector &increment, Vector &forces)
  {
    using CellVector = Eigen::Matrix<double, n_dofs, 1>;
    for (const auto &local_cell : grid.local_cells)
      {
        CellVector du, cell_force = CellVector::Zero();
        for (int i = 0; i < n_dofs; ++i)
          du[i] = increment.local_element(local_cell.dofs[i]);
        for (unsigned int q = 0; q < grid.quadrature.size(); ++q)
          {
            const unsigned int index = grid.point_index(*local_cell.cell, q);
            update_stress(du, index);
            cell_force +=
              volumes[index] *
              gradient_operators[index].nodal_forces<n_dofs>(
                IncrementalResponse::piola_stress(points[index].stress,
                                                  points[index].gradient));
          }
        add_to(local_cell, cell_force, forces);
      }
  }



  void
  Equilibrium::evaluate_forces(const Vector &increment,
                               const double  load_share,
                               Vector       &forces)
  {
    forces.zero_out_ghost_values();
    forces = 0.;
    if (grid.finite_element.n_dofs_per_cell() == 6)
      add_internal_forces<6>(increment, forces);
    else
      add_internal_forces<8>(increment, forces);
    forces.add(-load_share, nodal_weight);
    forces.update_ghost_values();
  }



  template <int n_dofs>
  Eigen::Matrix<double, n_dofs, n_dofs>
  Equilibrium::cell_tangent(const CellAccessor<dim> &cell,
                            const WallContact       &contact,
                            const double             elastic_share) const
  {
    Eigen::Matrix<double, n_dofs, n_dofs> result;
    result.setZero();
    for (unsigned int q = 0; q < grid.quadrature.size(); ++q)
      {
        const unsigned int   index = grid.point_index(cell, q);
        const MaterialPoint &point = points[index];
        const Matrix5        tangent =
          volumes[index] *
          IncrementalResponse::tangent(
            material.elasticity,
            point.stress_before,
            point.stress,
            point.gradient,
            IncrementalResponse::stabilized_projection_derivative(
              material, point.trial_stress, elastic_share));
        result += gradient_operators[index].stiffness<n_dofs>(tangent);
      }
    for (const unsigned int v : cell.vertex_indices())
      if (const auto *equations = contact.equations_at(cell.vertex_index(v)))
        {
          auto rows = result.template middleRows<dim>(dim * v);
          rows      = (to_eigen(equations->force_operator) * rows).eval();
        }
    return result;
  }



  template <int n_dofs>
  void
  Equilibrium::add_cell_tangents(const WallContact &contact,
                                 const double       elastic_share,
                                 TangentMatrix     &matrix) const
  {
    for (unsigned int i = 0; i < grid.local_cells.size(); ++i)
      matrix.add(i,
                 cell_tangent<n_dofs>(*grid.local_cells[i].cell,
                                      contact,
                                      elastic_share));
  }



  void
  Equilibrium::assemble_tangent(const WallContact &contact,
                                const double       elastic_share,
                                TangentMatrix     &matrix) const
  {
    matrix.set_zero();
    if (grid.finite_element.n_dofs_per_cell() == 6)
      add_cell_tangents<6>(contact, elastic_share, matrix);
    else
      add_cell_tangents<8>(contact, elastic_share, matrix);
    contact.add_stiffness([&matrix](const auto i, const auto j, const auto a) {
      matrix.add(i, j, a);
    });
  }
} // namespace Sandglass
