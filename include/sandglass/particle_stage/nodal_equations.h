#ifndef sandglass_particle_stage_nodal_equations_h
#define sandglass_particle_stage_nodal_equations_h

#include <sandglass/particle_stage/contact.h>
#include <sandglass/particle_stage/nodal_fields.h>

namespace Sandglass
{
  /**
   * Steps 4 and 5 of Section 4.4: the nodal accelerations of M a = F + F_c - R
   * with the lumped mass matrix. Nodes without mass get none.
   *
   * @param gravity    in m/s^2, so that F = M gravity.
   * @param time_step  in s.
   */
  inline void
  solve_acceleration(NodalFields                       &fields,
                     const Utilities::MPI::Partitioner &nodes,
                     Contact                           &contact,
                     const Tensor<1, dim>              &gravity,
                     const double                       time_step)
  {
    for (unsigned int node = 0; node < nodes.locally_owned_size(); ++node)
      {
        const double *sums = fields.sums.at(node);
        const double  mass = sums[NodalSum::mass];
        for (unsigned int d = 0; d < dim; ++d)
          fields.acceleration.at(node)[d] =
            mass > 0. ? gravity[d] - sums[NodalSum::internal_force + d] / mass :
                        0.;
      }
    contact.apply(fields.sums, time_step, fields.acceleration);
    fields.acceleration.update_ghosts();
  }



  /**
   * Step 7 of Section 4.4: v^L of M v^L = S^T M_d V (eq. 18) from the momentum
   * that fields.mapped_velocity holds, kept inside the walls.
   */
  inline void
  solve_mapped_velocity(NodalFields                       &fields,
                        const Utilities::MPI::Partitioner &nodes,
                        const Contact                     &contact)
  {
    for (unsigned int node = 0; node < nodes.locally_owned_size(); ++node)
      {
        const double mass = fields.sums.at(node)[NodalSum::mass];
        for (unsigned int d = 0; d < dim; ++d)
          {
            double &value = fields.mapped_velocity.at(node)[d];
            value         = mass > 0. ? value / mass : 0.;
          }
      }
    contact.constrain(fields.mapped_velocity);
    fields.mapped_velocity.update_ghosts();
  }
} // namespace Sandglass

#endif
