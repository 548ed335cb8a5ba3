#ifndef sandglass_flow_updated_lagrangian_material_equilibrium_set_up_templates_h
#define sandglass_flow_updated_lagrangian_material_equilibrium_set_up_templates_h

#include <sandglass/flow/updated_lagrangian/material_equilibrium.h>

namespace Sandglass
{
  template <typename Kinematics, typename Law>
  MaterialEquilibrium<Kinematics, Law>::MaterialEquilibrium(
    const ElementGrid<dim> &grid,
    const Law              &law,
    const double            density,
    const Tensor<1, dim>   &gravity)
    : MaterialEquilibrium(grid, law, density, [gravity](const Point<dim> &) {
      return gravity;
    })
  {}



  template <typename Kinematics, typename Law>
  MaterialEquilibrium<Kinematics, Law>::MaterialEquilibrium(
    const ElementGrid<dim> &grid,
    const Law              &law,
    const double            density,
    const BodyForce        &body_force)
    : Base(grid)
    , grid(grid)
    , law(law)
    , points(grid.triangulation.n_active_cells() * grid.quadrature.size())
    , gradient_operators(points.size())
    , volumes(points.size())
  {
    set_up_points();
    set_up_weight(density, body_force);
  }



  template <typename Kinematics, typename Law>
  void
  MaterialEquilibrium<Kinematics, Law>::set_up_points()
  {
    FEValues<dim> fe_values(grid.mapping,
                            grid.finite_element,
                            grid.quadrature,
                            update_values | update_gradients |
                              update_quadrature_points | update_JxW_values);
    for (const auto &local_cell : grid.local_cells)
      {
        fe_values.reinit(local_cell.cell);
        for (const unsigned int q : fe_values.quadrature_point_indices())
          set_up_point(fe_values, q, grid.point_index(*local_cell.cell, q));
      }
  }



  template <typename Kinematics, typename Law>
  void
  MaterialEquilibrium<Kinematics, Law>::set_up_weight(
    const double     density,
    const BodyForce &body_force)
  {
    FEValues<dim> fe_values(grid.mapping,
                            grid.finite_element,
                            grid.mass_quadrature,
                            update_values | update_quadrature_points |
                              update_JxW_values);
    auto         &nodal_weight = this->nodal_weight;
    nodal_weight.zero_out_ghost_values();
    for (const auto &local_cell : grid.local_cells)
      {
        fe_values.reinit(local_cell.cell);
        Eigen::VectorXd cell_weight =
          Eigen::VectorXd::Zero(fe_values.dofs_per_cell);
        for (const unsigned int q : fe_values.quadrature_point_indices())
          {
            const Point<dim> &position = fe_values.quadrature_point(q);
            const double      volume =
              fe_values.JxW(q) * Kinematics::measure(position);
            const Tensor<1, dim> force =
              density * volume * body_force(position);
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
} // namespace Sandglass

#endif
