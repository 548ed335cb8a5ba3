#ifndef sandglass_flow_updated_lagrangian_out_of_balance_h
#define sandglass_flow_updated_lagrangian_out_of_balance_h

#include <sandglass/flow/updated_lagrangian/equilibrium.h>
#include <sandglass/flow/updated_lagrangian/newmark_inertia.h>
#include <sandglass/flow/updated_lagrangian/node_constraints.h>

#include <algorithm>

namespace Sandglass
{
  /**
   * What one step's increment of displacement has to make zero: the nodal
   * out-of-balance forces with those of inertia, and at walls the equations of
   * NodeConstraints. At rest there is no inertia.
   *
   * Residuals are l2 norms over that of the whole weight's nodal forces. In
   * motion the norm is over the largest among weight, the material's forces
   * where the first evaluation finds them, and the force that would stop the
   * motion in one step: there are motions without weight.
   */
  template <int dim>
  class OutOfBalance
  {
  public:
    using Vector = DisplacementVector;

    /// @param inertia  null at rest.
    OutOfBalance(const ElementGrid<dim> &grid,
                 Equilibrium<dim>       &equilibrium,
                 NodeConstraints<dim>   &contact,
                 NewmarkInertia<dim>    *inertia = nullptr)
      : equilibrium(equilibrium)
      , contact(contact)
      , inertia(inertia)
      , forces(grid.make_vector())
      , displacement(grid.make_vector())
      , nodal(grid.make_vector())
    {}

    /**
     * @param displacement_before  at the start of the step, with ghost entries.
     * @param load_share           share of gravity at the end of the step.
     */
    void
    start_step(const Vector &displacement_before, const double load_share)
    {
      this->displacement_before = &displacement_before;
      this->load_share          = load_share;
      is_scaled                 = false;
    }

    /// Bring all state to an iterate, with ghost entries; returns the residual.
    double
    evaluate(const Vector &increment)
    {
      displacement.zero_out_ghost_values();
      displacement.equ(1., *displacement_before);
      displacement.add(1., increment);
      displacement.update_ghost_values();

      equilibrium.evaluate_forces(increment, load_share, forces);
      if (!is_scaled)
        set_scale();
      if (inertia)
        inertia->add_forces(increment, forces);
      contact.evaluate(forces, displacement, increment);
      nodal.zero_out_ghost_values();
      nodal.equ(1., forces);
      contact.replace_residual(nodal);
      return nodal.l2_norm() / scale;
    }

    /// NodeConstraints::update_contact() at the last iterate.
    unsigned int
    update_contact()
    {
      return contact.update_contact(load_share);
    }

    /// Of the last iterate, in N; without ghost entries.
    const Vector &
    residual() const
    {
      return nodal;
    }

    /// The derivative of residual() at the last iterate, see Equilibrium.
    void
    assemble_tangent(const double elastic_share, TangentMatrix<dim> &tangent)
    {
      equilibrium.assemble_tangent(contact, elastic_share, tangent);
      if (inertia)
        inertia->add_tangent(contact, tangent);
    }

  private:
    /// What residuals are relative to, in N; from the material's forces.
    void
    set_scale()
    {
      scale = equilibrium.weight().l2_norm();
      if (inertia)
        {
          scale =
            std::max({scale, forces.l2_norm(), inertia->stopping_force()});
          // Nothing moves, and nothing acts: any scale will do.
          if (scale == 0.)
            scale = 1.;
        }
      is_scaled = true;
    }

    Equilibrium<dim>          &equilibrium;
    NodeConstraints<dim>      &contact;
    NewmarkInertia<dim> *const inertia;
    Vector                     forces, displacement, nodal;
    const Vector              *displacement_before = nullptr;
    double                     load_share          = 0.;
    double                     scale               = 0.;
    bool                       is_scaled           = false;
  };
} // namespace Sandglass

#endif
