#ifndef sandglass_flow_updated_lagrangian_dynamic_relaxation_h
#define sandglass_flow_updated_lagrangian_dynamic_relaxation_h

#include <sandglass/flow/updated_lagrangian/out_of_balance.h>

namespace Sandglass
{
  /// How DynamicRelaxation ended.
  struct RelaxationResult
  {
    bool         has_converged;
    unsigned int n_steps;
    double       residual;
  };

  /**
   * One load step as the damped motion of the nodes towards rest (Underwood
   * 1983): explicit steps of length one with fictitious masses, which make each
   * node's motion as fast as stability allows, and a damping that follows the
   * slowest mode in the last step.
   *
   * It solves the same equations as NewtonSolver, from the same state, so that
   * both have the same answer; but it needs no tangent, and goes on where
   * Newton's method runs in circles between sticking, sliding and yielding.
   */
  template <int dim>
  class DynamicRelaxation
  {
  public:
    using Vector = DisplacementVector;

    DynamicRelaxation(const FilledGrid<dim> &grid,
                      Equilibrium<dim>      &equilibrium,
                      WallContact<dim>      &contact);

    /**
     * @param displacement_before  at the start of the load step.
     * @param load_share           share of gravity at the end of the step.
     */
    void
    start_step(const Vector &displacement_before, const double load_share);

    /**
     * Go towards rest until contact doesn't change and the residual is small.
     *
     * @param largest_residual  see OutOfBalance.
     * @param most_steps        after which the relaxation fails.
     * @param[in,out] increment of the displacement: where to start, from rest,
     *                          and where it ends. With ghost entries.
     */
    RelaxationResult
    relax(const double       largest_residual,
          const unsigned int most_steps,
          Vector            &increment);

    /// Bring all state to an iterate; returns the residual.
    double
    evaluate(const Vector &increment)
    {
      return out_of_balance.evaluate(increment);
    }

  private:
    /// Take masses for the contact that there is.
    void
    find_masses();

    /// One step on from the last evaluated iterate; `velocity` is per step.
    void
    step(Vector &increment);

    /// Twice the frequency of the mode that the last step followed.
    double
    damping();

    const FilledGrid<dim> &grid;
    OutOfBalance<dim>      out_of_balance;
    Vector                 masses, velocity, residual_before, work;
  };
} // namespace Sandglass

#endif
