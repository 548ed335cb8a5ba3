#ifndef sandglass_flow_updated_lagrangian_material_equilibrium_templates_h
#define sandglass_flow_updated_lagrangian_material_equilibrium_templates_h

#include <sandglass/flow/updated_lagrangian/material_equilibrium.h>

namespace Sandglass
{
  template <int dim>
  Eigen::Matrix<double, dim, dim>
  to_eigen(const Tensor<2, dim> &tensor)
  {
    Eigen::Matrix<double, dim, dim> matrix;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        matrix(i, j) = tensor[i][j];
    return matrix;
  }



  template <typename Kinematics, typename Law>
  MaterialEquilibrium<Kinematics, Law>::MaterialEquilibrium(
    const FilledGrid<dim> &grid,
    const Law             &law,
    const double           density,
    const Tensor<1, dim>  &gravity)
    : MaterialEquilibrium(grid, law, density, [gravity](const Point<dim> &) {
      return gravity;
    })
  {}



  template <typename Kinematics, typename Law>
  MaterialEquilibrium<Kinematics, Law>::MaterialEquilibrium(
    const FilledGrid<dim> &grid,
    const Law             &law,
    const double           density,
    const BodyForce       &body_force)
    : Base(grid)
    , grid(grid)
    , law(law)
    , points(grid.triangulation.n_active_cells() * grid.quadrature.size())
    , gradient_operators(points.size())
    , volumes(points.size())
  {
    set_up(density, body_force);
  }



  template <typename Kinematics, typename Law>
  void
  MaterialEquilibrium<Kinematics, Law>::add_to(
    const LocalCell                        &local_cell,
    const Eigen::Ref<const Eigen::VectorXd> values,
    Vector                                 &vector) const
  {
    const unsigned int n_owned = grid.n_owned_dofs();
    for (unsigned int i = 0; i < values.size(); ++i)
      if (local_cell.dofs[i] < n_owned)
        vector.local_element(local_cell.dofs[i]) += values[i];
  }



  template <typename Kinematics, typename Law>
  void
  MaterialEquilibrium<Kinematics, Law>::set_up(const double     density,
                                               const BodyForce &body_force)
  {
    FEValues<dim> fe_values(grid.mapping,
                            grid.finite_element,
                            grid.quadrature,
                            update_values | update_gradients |
                              update_quadrature_points | update_JxW_values);
    auto         &nodal_weight = this->nodal_weight;
    nodal_weight.zero_out_ghost_values();
    for (const auto &local_cell : grid.local_cells)
      {
        fe_values.reinit(local_cell.cell);
        Eigen::VectorXd cell_weight =
          Eigen::VectorXd::Zero(fe_values.dofs_per_cell);
        for (const unsigned int q : fe_values.quadrature_point_indices())
          {
            const unsigned int index = grid.point_index(*local_cell.cell, q);
            set_up_point(fe_values, q, index);
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



  template <typename Kinematics, typename Law>
  void
  MaterialEquilibrium<Kinematics, Law>::set_up_point(
    const FEValues<dim> &fe_values,
    const unsigned int   q,
    const unsigned int   index)
  {
    const Point<dim> &position = fe_values.quadrature_point(q);
    volumes[index] = fe_values.JxW(q) * Kinematics::measure(position);
    points[index].law_state_before = points[index].law_state =
      law.initial_state();

    for (const unsigned int i : fe_values.dof_indices())
      if (grid.component(i) == 0)
        gradient_operators[index].set_node(i / dim,
                                           fe_values.shape_grad(i, q),
                                           Kinematics::has_hoop_strain ?
                                             fe_values.shape_value(i, q) /
                                               position[0] :
                                             0.);
  }



  template <typename Kinematics, typename Law>
  void
  MaterialEquilibrium<Kinematics, Law>::start_step()
  {
    for (const auto &local_cell : grid.local_cells)
      for (unsigned int q = 0; q < grid.quadrature.size(); ++q)
        start_step(grid.point_index(*local_cell.cell, q));
  }



  template <typename Kinematics, typename Law>
  void
  MaterialEquilibrium<Kinematics, Law>::start_step(const unsigned int index)
  {
    MaterialPoint &point = points[index];
    volumes[index] *= Kinematics::Response::volume_ratio(point.gradient);
    gradient_operators[index].move_reference(point.gradient);

    point.gradient.setZero();
    point.stress_before       = point.stress;
    point.law_state_before    = point.law_state;
    point.volume_ratio_before = point.volume_ratio;
  }



  template <typename Kinematics, typename Law>
  template <int n_dofs>
  void
  MaterialEquilibrium<Kinematics, Law>::update_stress(
    const Eigen::Matrix<double, n_dofs, 1> &increment,
    const unsigned int                      index)
  {
    MaterialPoint &point = points[index];
    point.gradient =
      gradient_operators[index].template gradient<n_dofs>(increment);
    const auto step = Kinematics::Response::increment(point.gradient);
    point.stress    = rotate(point.stress_before, step.rotation);
    point.law_state = point.law_state_before;
    law.correct(point.stress, point.law_state, law.predict(step, 0.));
    point.volume_ratio = point.volume_ratio_before *
                         Kinematics::Response::volume_ratio(point.gradient);
  }



  template <typename Kinematics, typename Law>
  template <int n_dofs>
  void
  MaterialEquilibrium<Kinematics, Law>::add_internal_forces(
    const Vector &increment,
    Vector       &forces)
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
              gradient_operators[index].template nodal_forces<n_dofs>(
                Kinematics::Response::piola_stress(points[index].stress,
                                                   points[index].gradient));
          }
        add_to(local_cell, cell_force, forces);
      }
  }



  template <typename Kinematics, typename Law>
  void
  MaterialEquilibrium<Kinematics, Law>::evaluate_forces(const Vector &increment,
                                                        const double load_share,
                                                        Vector      &forces)
  {
    forces.zero_out_ghost_values();
    forces = 0.;
    if (has_simplices())
      add_internal_forces<n_simplex_dofs>(increment, forces);
    else
      add_internal_forces<n_cube_dofs>(increment, forces);
    forces.add(-load_share, this->nodal_weight);
    forces.update_ghost_values();
  }



  template <typename Kinematics, typename Law>
  template <int n_dofs>
  Eigen::Matrix<double, n_dofs, n_dofs>
  MaterialEquilibrium<Kinematics, Law>::cell_tangent(
    const CellAccessor<dim> &cell,
    const WallContact<dim>  &contact,
    const double             elastic_share) const
  {
    Eigen::Matrix<double, n_dofs, n_dofs> result;
    result.setZero();
    for (unsigned int q = 0; q < grid.quadrature.size(); ++q)
      {
        const unsigned int   index = grid.point_index(cell, q);
        const MaterialPoint &point = points[index];
        const auto           tangent =
          (volumes[index] *
           Kinematics::Response::tangent(point.stress_before,
                                         point.stress,
                                         point.gradient,
                                         tangent_of_law(point, elastic_share)))
            .eval();
        result += gradient_operators[index].template stiffness<n_dofs>(tangent);
      }
    for (const unsigned int v : cell.vertex_indices())
      if (const auto *equations = contact.equations_at(cell.vertex_index(v)))
        {
          auto rows = result.template middleRows<dim>(dim * v);
          rows      = (to_eigen(equations->force_operator) * rows).eval();
        }
    return result;
  }



  template <typename Kinematics, typename Law>
  template <int n_dofs>
  void
  MaterialEquilibrium<Kinematics, Law>::add_cell_tangents(
    const WallContact<dim> &contact,
    const double            elastic_share,
    TangentMatrix<dim>     &matrix) const
  {
    for (unsigned int i = 0; i < grid.local_cells.size(); ++i)
      matrix.add(i,
                 cell_tangent<n_dofs>(*grid.local_cells[i].cell,
                                      contact,
                                      elastic_share));
  }



  template <typename Kinematics, typename Law>
  void
  MaterialEquilibrium<Kinematics, Law>::assemble_tangent(
    const WallContact<dim> &contact,
    const double            elastic_share,
    TangentMatrix<dim>     &matrix) const
  {
    matrix.set_zero();
    if (has_simplices())
      add_cell_tangents<n_simplex_dofs>(contact, elastic_share, matrix);
    else
      add_cell_tangents<n_cube_dofs>(contact, elastic_share, matrix);
    contact.add_stiffness([&matrix](const auto i, const auto j, const auto a) {
      matrix.add(i, j, a);
    });
  }
} // namespace Sandglass

#endif
