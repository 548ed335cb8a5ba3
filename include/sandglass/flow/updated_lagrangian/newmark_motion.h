#ifndef sandglass_flow_updated_lagrangian_newmark_motion_h
#define sandglass_flow_updated_lagrangian_newmark_motion_h

#include <sandglass/flow/updated_lagrangian/newmark_inertia.h>
#include <sandglass/flow/updated_lagrangian/newton_solver.h>

#include <functional>
#include <limits>

namespace Sandglass
{
  /**
   * Motion of the material in the updated Lagrangian formulation (paper,
   * Section 5.3; doc/theory.md): Newmark's method in time, each step solved by
   * Newton's method from the same equations as the state at rest, with inertia.
   *
   * Steps that Newton's method can't solve are halved, and so are those in
   * which material at a quadrature point loses half its volume. After success
   * steps grow again, up to the one asked for.
   */
  template <int dim>
  class NewmarkMotion
  {
  public:
    using Vector = DisplacementVector;

    struct Parameters
    {
      double            time_step = 0.01; ///< the longest, in s
      NewmarkParameters newmark;
      /// By which a node may be displaced along an axis in one step, in m.
      double longest_way = std::numeric_limits<double>::infinity();
    };

    /// Share of the weight that acts at a time in s.
    using LoadHistory = std::function<double(const double)>;

    /**
     * All arguments have to outlive the object.
     *
     * @param equilibrium  of the grid, in the state where the motion starts.
     * @param mass         with the equilibrium's density.
     * @param constraints  plain NodeConstraints for a free body.
     * @param solver_parameters  the residual at which Newton's method stops,
     *                     and up to how many unknowns it solves directly.
     * @param relative_residual  instead of theirs, unless it is 0.
     */
    NewmarkMotion(const ElementGrid<dim>      &grid,
                  Equilibrium<dim>            &equilibrium,
                  const ConsistentMass<dim>   &mass,
                  NodeConstraints<dim>        &constraints,
                  const Parameters            &parameters,
                  const StaticStageParameters &solver_parameters,
                  const double                 relative_residual = 0.);

    /// The whole weight acts at all times, unless this says something else, as
    /// manufactured solutions do.
    void
    set_load_history(const LoadHistory &load_share)
    {
      this->load_share = load_share;
    }

    /**
     * Begin at time 0. The acceleration follows from the forces. Collective.
     * Throws RunError where there is none.
     *
     * @param displacement  since the unloaded state, in m.
     * @param velocity      in m/s; as the constraints allow.
     */
    void
    start(const Vector &displacement, const Vector &velocity);

    /**
     * Go on from a motion that is known, without the search for an
     * acceleration.
     *
     * @param time  in s.
     * @param first_step  to be tried, in s.
     */
    void
    go_on(const double  time,
          const double  first_step,
          const Vector &displacement,
          const Vector &velocity,
          const Vector &acceleration);

    /// One step. Collective. Throws RunError where the smallest one fails.
    void
    step();

    /// One step of the length that step() would try first, but no longer than
    /// this. Collective. Returns whether it has a solution; if not, the next
    /// one to be tried is half as long.
    bool
    try_step(const double longest);

    /// Let the next step damp what its length doesn't resolve: with delta = 1,
    /// where forces have jumped and the acceleration at its start says little.
    void
    damp_next_step(const bool damps = true)
    {
      is_damped = damps;
    }

    bool
    damps_next_step() const
    {
      return is_damped;
    }

    /// What step() tries first, in s.
    double
    next_time_step() const
    {
      return next_step;
    }

    /// Whether steps have become as short as they may.
    bool
    has_smallest_step() const;

    double
    time() const
    {
      return now;
    }

    /// The last step's, in s; 0 before the first one.
    double
    last_time_step() const
    {
      return last_step;
    }

    /// Since the unloaded state, in m, with ghost entries.
    const Vector &
    displacement() const
    {
      return total_displacement;
    }

    /// In m/s, with ghost entries.
    const Vector &
    velocity() const
    {
      return inertia.velocity;
    }

    /// In m/s^2, with ghost entries.
    const Vector &
    acceleration() const
    {
      return inertia.acceleration;
    }

    /// In J (plane strain: per m of depth).
    struct Energies
    {
      double kinetic;
      double elastic;    ///< as far as the law knows it
      double dissipated; ///< plastic work since the unloaded state
      double potential;  ///< of the whole weight; 0 at the unloaded state
    };

    /// Now. Collective.
    Energies
    energies() const;

    /// Newton's iterations since the beginning, and steps that failed.
    struct Effort
    {
      unsigned int n_iterations = 0, n_failures = 0;
    };

    const Effort &
    effort() const
    {
      return so_far;
    }

  private:
    /// Solve for a step's increment; false if it fails, with contact as before.
    bool
    solve(const double time_step, Vector &increment);

    /// Make the end of a solved step the start of the next one.
    void
    accept(const double time_step, const Vector &increment);

    /// See NodeConstraints::correct_motion().
    void
    correct_motion();

    /// From the forces at the start.
    void
    find_acceleration();

    const Parameters      parameters;
    Equilibrium<dim>     &equilibrium;
    NodeConstraints<dim> &constraints;
    NewmarkInertia<dim>   inertia;
    NewtonSolver<dim>     newton;
    LoadHistory           load_share = [](const double) { return 1.; };

    double       now = 0., last_step = 0.;
    double       next_step; ///< to be tried next
    bool         is_damped       = false;
    unsigned int last_iterations = 0; ///< of Newton's method
    Vector       total_displacement;
    Effort       so_far;
  };
} // namespace Sandglass

#endif
