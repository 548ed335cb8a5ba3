#ifndef sandglass_flow_updated_lagrangian_dynamic_relaxation_h
#define sandglass_flow_updated_lagrangian_dynamic_relaxation_h

#include <sandglass/flow/updated_lagrangian/out_of_balance.h>
#include <sandglass/flow/updated_lagrangian/tangent_preconditioner.h>

#include <memory>

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
   * 1983): explicit steps of length one with fictitious inertia, and a damping
   * that follows the slowest mode in the last step.
   *
   * The inertia is the elastic stiffness, not masses at the nodes. While
   * material is elastic, all its modes so have one frequency, however fine the
   * mesh is; with masses the number of steps would grow with the number of
   * cells from wall to wall. What remains slow is plastic flow.
   *
   * It solves the same equations as NewtonSolver, from the same state, so that
   * both have the same answer; but it needs no exact tangent, and goes on where
   * Newton's method runs in circles between sticking, sliding and yielding.
   */
  template <int dim>
  class DynamicRelaxation
  {
  public:
    using Vector = DisplacementVector;

    /// @param storage  of the elastic stiffness: factorized if by columns,
    ///                 inverted approximately by multigrid if by rows.
    DynamicRelaxation(const ElementGrid<dim> &grid,
                      Equilibrium<dim>       &equilibrium,
                      NodeConstraints<dim>   &contact,
                      const TangentStorage    storage);

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
    /// Stop, and take the elastic stiffness with the contact that there is;
    /// false if it is singular.
    bool
    find_inertia();

    /// One step on from the last evaluated iterate.
    void
    step(Vector &increment);

    /// The square of the frequency of the motion in the last step, by its
    /// Rayleigh quotient; 0 at rest.
    double
    squared_frequency();

    const ElementGrid<dim> &grid;
    const TangentStorage    storage;
    OutOfBalance<dim>       out_of_balance;

    /// Made when they are needed: most scenes come to rest without.
    std::unique_ptr<TangentMatrix<dim>>         stiffness;
    std::unique_ptr<TangentPreconditioner<dim>> inverse_stiffness;

    double inertia_factor = 1.; ///< inertia over elastic stiffness
    Vector velocity;            ///< per step
    Vector momentum;            ///< inertia times velocity
    Vector residual_before, work;
  };
} // namespace Sandglass

#endif
