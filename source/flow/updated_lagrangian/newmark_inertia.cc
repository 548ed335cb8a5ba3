#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/updated_lagrangian/newmark_inertia.h>

namespace Sandglass
{
  template <int dim>
  NewmarkInertia<dim>::NewmarkInertia(const ElementGrid<dim>    &grid,
                                      const ConsistentMass<dim> &mass,
                                      const NewmarkParameters   &parameters)
    : mass(mass)
    , velocity(grid.make_vector())
    , acceleration(grid.make_vector())
    , parameters(parameters)
    , acceleration_at_end(grid.make_vector())
  {}



  template <int dim>
  void
  NewmarkInertia<dim>::start_step(const double time_step)
  {
    Assert(time_step > 0., ExcInternalError());
    this->time_step = time_step;
    Vector momentum(velocity);
    momentum.zero_out_ghost_values();
    momentum = 0.;
    mass.add_forces(velocity, momentum);
    stopping_force_of_step = momentum.l2_norm() / time_step;
  }



  template <int dim>
  DisplacementVector
  NewmarkInertia<dim>::increment_of_steady_acceleration() const
  {
    Vector increment(velocity);
    increment.zero_out_ghost_values();
    increment.sadd(time_step, time_step * time_step / 2., acceleration);
    increment.update_ghost_values();
    return increment;
  }



  template <int dim>
  void
  NewmarkInertia<dim>::set_acceleration_at_end(const Vector &increment)
  {
    const double alpha = parameters.alpha;
    acceleration_at_end.zero_out_ghost_values();
    acceleration_at_end.equ(1. / (alpha * time_step * time_step), increment);
    acceleration_at_end.add(-1. / (alpha * time_step), velocity);
    acceleration_at_end.add(-(0.5 - alpha) / alpha, acceleration);
    acceleration_at_end.update_ghost_values();
  }



  template <int dim>
  void
  NewmarkInertia<dim>::add_forces(const Vector &increment, Vector &forces)
  {
    set_acceleration_at_end(increment);
    forces.zero_out_ghost_values();
    mass.add_forces(acceleration_at_end, forces);
    forces.update_ghost_values();
  }



  template <int dim>
  void
  NewmarkInertia<dim>::add_tangent(const NodeConstraints<dim> &constraints,
                                   TangentMatrix<dim>         &tangent) const
  {
    mass.add_tangent(1. / (parameters.alpha * time_step * time_step),
                     constraints,
                     tangent);
  }



  template <int dim>
  void
  NewmarkInertia<dim>::end_step(const Vector &increment)
  {
    set_acceleration_at_end(increment);
    velocity.zero_out_ghost_values();
    velocity.add(time_step * (1. - parameters.delta), acceleration);
    velocity.add(time_step * parameters.delta, acceleration_at_end);
    velocity.update_ghost_values();
    acceleration.swap(acceleration_at_end);
  }



#define INSTANTIATE(dim) template class NewmarkInertia<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
