#ifndef sandglass_flow_updated_lagrangian_newmark_inertia_h
#define sandglass_flow_updated_lagrangian_newmark_inertia_h

#include <sandglass/flow/updated_lagrangian/consistent_mass.h>

namespace Sandglass
{
  /// Parameters of Newmark's method. With delta = 1/2 it is of second order,
  /// and with alpha = 1/4 beside it keeps the energy of linear motions.
  struct NewmarkParameters
  {
    double delta = 0.5, alpha = 0.25;
  };

  /**
   * Newmark's method (newmark1959): the motion at the start of a step, and what
   * the step's increment of displacement Du makes of velocity and acceleration,
   *
   *     a_1 = (Du - dt v_0 - dt^2 (1/2 - alpha) a_0) / (alpha dt^2)
   *     v_1 = v_0 + dt ((1 - delta) a_0 + delta a_1)
   *
   * with the inertia forces M a_1 and their derivative M / (alpha dt^2).
   */
  template <int dim>
  class NewmarkInertia
  {
  public:
    using Vector = DisplacementVector;

    NewmarkInertia(const ElementGrid<dim>    &grid,
                   const ConsistentMass<dim> &mass,
                   const NewmarkParameters   &parameters);

    /// @param time_step  dt in s, positive.
    void
    start_step(const double time_step);

    /// Other parameters for the steps that start from here on.
    void
    set_parameters(const NewmarkParameters &parameters)
    {
      this->parameters = parameters;
    }

    /// What the increment is if the acceleration doesn't change; with ghost
    /// entries.
    Vector
    increment_of_steady_acceleration() const;

    /// Add M a_1 to nodal forces in N, with ghost entries.
    void
    add_forces(const Vector &increment, Vector &forces);

    /// Add the derivative of add_forces() to the tangent of the nodes'
    /// equations.
    void
    add_tangent(const NodeConstraints<dim> &constraints,
                TangentMatrix<dim>         &tangent) const;

    /// l2 norm of the nodal forces in N that would stop the motion in one step.
    double
    stopping_force() const
    {
      return stopping_force_of_step;
    }

    /// Make the end of the step with this increment the start of the next one.
    void
    end_step(const Vector &increment);

    const ConsistentMass<dim> &mass;

    Vector velocity;     ///< at the start of the step, in m/s, with ghosts
    Vector acceleration; ///< likewise, in m/s^2

  private:
    /// a_1, with ghost entries.
    void
    set_acceleration_at_end(const Vector &increment);

    NewmarkParameters parameters;
    double            time_step              = 0.;
    double            stopping_force_of_step = 0.;
    Vector            acceleration_at_end;
  };
} // namespace Sandglass

#endif
