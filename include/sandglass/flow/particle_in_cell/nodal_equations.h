#ifndef sandglass_flow_particle_in_cell_nodal_equations_h
#define sandglass_flow_particle_in_cell_nodal_equations_h

#include <sandglass/flow/particle_in_cell/contact.h>
#include <sandglass/flow/particle_in_cell/mass_matrix.h>
#include <sandglass/flow/particle_in_cell/nodal_fields.h>

namespace Sandglass
{
  /**
   * Step 2 of Section 4.4: v of M v = S^T M_d V (eq. 11). Contact needs it as
   * the momentum M_I v, which is put into fields.sums; with the lumped matrix
   * it is there already.
   */
  template <typename Setting>
  void
  solve_velocity(NodalFields<Setting::dim>         &fields,
                 const Utilities::MPI::Partitioner &nodes,
                 MassMatrix<Setting>               &mass_matrix)
  {
    constexpr int dim = Setting::dim;
    using NodalSum    = Sandglass::NodalSum<dim>;
    if (mass_matrix.is_lumped())
      return;
    NodalField<dim> &velocity = fields.mapped_velocity; // not yet in use
    for (unsigned int node = 0; node < nodes.locally_owned_size(); ++node)
      for (unsigned int d = 0; d < dim; ++d)
        velocity.at(node)[d] = fields.sums.at(node)[NodalSum::momentum + d];
    mass_matrix.solve(velocity);
    for (unsigned int node = 0; node < nodes.locally_owned_size(); ++node)
      {
        double *sums = fields.sums.at(node);
        for (unsigned int d = 0; d < dim; ++d)
          sums[NodalSum::momentum + d] =
            sums[NodalSum::mass] * velocity.at(node)[d];
      }
  }



  /**
   * Steps 4 and 5 of Section 4.4: the nodal accelerations of M a = F + F_c - R.
   * Contact finds which nodes a wall holds, and the friction, with the lumped
   * matrix. Nodes without mass get no acceleration.
   *
   * @param gravity    in m/s^2, so that F = M gravity.
   * @param time_step  in s.
   * @param brake      called with the acceleration before contact sees it.
   */
  template <typename Setting, typename Brake>
  void
  solve_acceleration(NodalFields<Setting::dim>         &fields,
                     const Utilities::MPI::Partitioner &nodes,
                     MassMatrix<Setting>               &mass_matrix,
                     Contact<Setting::dim>             &contact,
                     const Tensor<1, Setting::dim>     &gravity,
                     const double                       time_step,
                     const Brake                       &brake)
  {
    constexpr int dim = Setting::dim;
    using NodalSum    = Sandglass::NodalSum<dim>;
    for (unsigned int node = 0; node < nodes.locally_owned_size(); ++node)
      {
        const double *sums = fields.sums.at(node);
        const double  mass = sums[NodalSum::mass];
        for (unsigned int d = 0; d < dim; ++d)
          fields.acceleration.at(node)[d] =
            mass > 0. ? gravity[d] - sums[NodalSum::internal_force + d] / mass :
                        0.;
      }
    brake(fields.acceleration);
    contact.apply(fields.sums, time_step, fields.acceleration);
    if (!mass_matrix.is_lumped())
      contact.add_forces(mass_matrix.solve_held(
                           fields.sums,
                           [&contact](NodalField<dim> &field) {
                             contact.release_held(field);
                           },
                           fields.acceleration),
                         time_step);
    fields.acceleration.update_ghosts();
  }



  /**
   * Step 7 of Section 4.4: v^L of M v^L = S^T M_d V (eq. 18) from the momentum
   * that fields.mapped_velocity holds, kept inside the walls.
   */
  template <typename Setting>
  void
  solve_mapped_velocity(NodalFields<Setting::dim> &fields,
                        MassMatrix<Setting>       &mass_matrix,
                        Contact<Setting::dim>     &contact,
                        const double               time_step)
  {
    constexpr int dim = Setting::dim;
    mass_matrix.solve_lumped(fields.sums, fields.mapped_velocity);
    contact.constrain(fields.mapped_velocity);
    if (!mass_matrix.is_lumped())
      {
        mass_matrix.solve_held(
          fields.sums,
          [&contact](NodalField<dim> &field) { contact.release_held(field); },
          fields.mapped_velocity);
        contact.constrain(fields.mapped_velocity);
      }
    contact.stretch_friction(fields.mapped_velocity, time_step);
    fields.mapped_velocity.update_ghosts();
  }
} // namespace Sandglass

#endif
