#ifndef sandglass_flow_updated_lagrangian_out_of_balance_h
#define sandglass_flow_updated_lagrangian_out_of_balance_h

#include <sandglass/flow/updated_lagrangian/equilibrium.h>
#include <sandglass/flow/updated_lagrangian/wall_contact.h>

namespace Sandglass
{
  /**
   * What one load step's increment of displacement has to make zero: the nodal
   * out-of-balance forces, and at walls WallContact's equations.
   *
   * Residuals are l2 norms over that of the whole weight's nodal forces.
   */
  template <int dim>
  class OutOfBalance
  {
  public:
    using Vector = DisplacementVector;

    OutOfBalance(const FilledGrid<dim> &grid,
                 Equilibrium<dim>      &equilibrium,
                 WallContact<dim>      &contact)
      : equilibrium(equilibrium)
      , contact(contact)
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
      contact.evaluate(forces, displacement, increment);
      nodal.zero_out_ghost_values();
      nodal.equ(1., forces);
      contact.replace_residual(nodal);
      return nodal.l2_norm() / equilibrium.weight().l2_norm();
    }

    /// WallContact::update_contact() at the last iterate.
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
    }

  private:
    Equilibrium<dim> &equilibrium;
    WallContact<dim> &contact;
    Vector            forces, displacement, nodal;
    const Vector     *displacement_before = nullptr;
    double            load_share          = 0.;
  };
} // namespace Sandglass

#endif
