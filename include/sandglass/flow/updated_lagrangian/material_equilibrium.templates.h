#ifndef sandglass_flow_updated_lagrangian_material_equilibrium_templates_h
#define sandglass_flow_updated_lagrangian_material_equilibrium_templates_h

#include <deal.II/base/mpi.h>

#include <sandglass/flow/updated_lagrangian/material_equilibrium.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
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
    point.dissipation_before  = point.dissipation;
  }



  template <typename Kinematics, typename Law>
  void
  MaterialEquilibrium<Kinematics, Law>::move_reference(
    const Vector &displacement)
  {
    with_n_dofs([&](const auto n) {
      constexpr int n_dofs = decltype(n)::value;
      for (const auto &local_cell : grid.local_cells)
        {
          Eigen::Matrix<double, n_dofs, 1> u;
          for (int i = 0; i < n_dofs; ++i)
            u[i] = displacement.local_element(local_cell.dofs[i]);
          for (unsigned int q = 0; q < grid.quadrature.size(); ++q)
            {
              const unsigned int index = grid.point_index(*local_cell.cell, q);
              const Gradient     H =
                gradient_operators[index].template gradient<n_dofs>(u);
              volumes[index] *= Kinematics::Response::volume_ratio(H);
              gradient_operators[index].move_reference(H);
            }
        }
    });
  }



  template <typename Kinematics, typename Law>
  template <typename Increment>
  bool
  MaterialEquilibrium<Kinematics, Law>::close_gap(const MaterialPoint &point,
                                                  Increment &step) const
  {
    const double closing =
      std::log(largest_stressed_volume_ratio() / point.volume_ratio_before);
    const double change = std::log(step.jacobian);
    if (change >= closing)
      return false;
    step.add_volume_change(change - closing - step.volume_change());
    return true;
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
    point.volume_ratio = point.volume_ratio_before *
                         Kinematics::Response::volume_ratio(point.gradient);
    auto step       = increment_of(point);
    point.stress    = rotate(point.stress_before, step.rotation);
    point.law_state = point.law_state_before;
    if (point.volume_ratio_before > largest_stressed_volume_ratio())
      {
        point.stress.setZero();
        if (!close_gap(point, step))
          {
            point.dissipation = point.dissipation_before;
            return;
          }
      }
    const double plastic_work = law.correct(point.stress,
                                            point.law_state,
                                            law.predict(step, this->time_step));
    point.dissipation =
      point.dissipation_before + plastic_work * point.volume_ratio;
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
    with_n_dofs([&](const auto n) {
      this->template add_internal_forces<decltype(n)::value>(increment, forces);
    });
    forces.add(-load_share, this->nodal_weight);
    forces.update_ghost_values();
  }



  template <typename Kinematics, typename Law>
  template <int n_dofs>
  Eigen::Matrix<double, n_dofs, n_dofs>
  MaterialEquilibrium<Kinematics, Law>::cell_tangent(
    const LocalCell            &local_cell,
    const NodeConstraints<dim> &constraints,
    const double                elastic_share) const
  {
    Eigen::Matrix<double, n_dofs, n_dofs> result;
    result.setZero();
    for (unsigned int q = 0; q < grid.quadrature.size(); ++q)
      {
        const unsigned int   index = grid.point_index(*local_cell.cell, q);
        const MaterialPoint &point = points[index];
        const auto           tangent =
          (volumes[index] *
           Kinematics::Response::tangent(point.stress_before,
                                         point.stress,
                                         point.gradient,
                                         tangent_of_law(point, elastic_share),
                                         integration()))
            .eval();
        result += gradient_operators[index].template stiffness<n_dofs>(tangent);
      }
    constraints.replace_rows(local_cell, result);
    return result;
  }



  template <typename Kinematics, typename Law>
  template <int n_dofs>
  void
  MaterialEquilibrium<Kinematics, Law>::add_cell_tangents(
    const NodeConstraints<dim> &constraints,
    const double                elastic_share,
    TangentMatrix<dim>         &matrix) const
  {
    for (unsigned int i = 0; i < grid.local_cells.size(); ++i)
      matrix.add(i,
                 cell_tangent<n_dofs>(grid.local_cells[i],
                                      constraints,
                                      elastic_share));
  }



  template <typename Kinematics, typename Law>
  void
  MaterialEquilibrium<Kinematics, Law>::assemble_tangent(
    const NodeConstraints<dim> &constraints,
    const double                elastic_share,
    TangentMatrix<dim>         &matrix) const
  {
    matrix.set_zero();
    with_n_dofs([&](const auto n) {
      this->template add_cell_tangents<decltype(n)::value>(constraints,
                                                           elastic_share,
                                                           matrix);
    });
    constraints.add_stiffness(matrix);
  }



  template <typename Kinematics, typename Law>
  double
  MaterialEquilibrium<Kinematics, Law>::smallest_volume_ratio() const
  {
    double smallest = 1.;
    for (const auto &local_cell : grid.local_cells)
      for (unsigned int q = 0; q < grid.quadrature.size(); ++q)
        smallest =
          std::min(smallest,
                   Kinematics::Response::volume_ratio(
                     points[grid.point_index(*local_cell.cell, q)].gradient));
    return Utilities::MPI::min(smallest, grid.triangulation.get_communicator());
  }



  template <typename Kinematics, typename Law>
  auto
  MaterialEquilibrium<Kinematics, Law>::energies() const ->
    typename Base::Energies
  {
    double elastic = 0., dissipated = 0.;
    for (const auto &local_cell : grid.local_cells)
      if (local_cell.cell->is_locally_owned())
        for (unsigned int q = 0; q < grid.quadrature.size(); ++q)
          {
            const unsigned int   index = grid.point_index(*local_cell.cell, q);
            const MaterialPoint &point = points[index];
            elastic +=
              volumes[index] *
              law.energy_density(point.stress_before, point.law_state_before);
            dissipated += volumes[index] / point.volume_ratio_before *
                          point.dissipation_before;
          }
    const MPI_Comm communicator = grid.triangulation.get_communicator();
    return {Utilities::MPI::sum(elastic, communicator),
            Utilities::MPI::sum(dissipated, communicator)};
  }
} // namespace Sandglass

#endif
