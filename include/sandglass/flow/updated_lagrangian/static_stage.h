#ifndef sandglass_flow_updated_lagrangian_static_stage_h
#define sandglass_flow_updated_lagrangian_static_stage_h

#include <deal.II/base/conditional_ostream.h>

#include <sandglass/material/material_parameters.h>
#include <sandglass/flow/updated_lagrangian/equilibrium.h>
#include <sandglass/flow/updated_lagrangian/newton_solver.h>
#include <sandglass/flow/updated_lagrangian/static_stage_parameters.h>
#include <sandglass/flow/updated_lagrangian/static_state.h>
#include <sandglass/flow/updated_lagrangian/wall_contact.h>

#include <string>

namespace Sandglass
{
  /**
   * The state at rest under gravity with the outlet closed, by the updated
   * Lagrangian finite element method (paper, Section 5; doc/theory.md): load
   * steps of NewtonSolver, cut where they don't converge.
   */
  template <int dim>
  class StaticStage
  {
  public:
    /// Logs the number of unknowns, and one line per load step.
    StaticStage(const Scene<dim>                 &scene,
                const MaterialParameters    &material_parameters,
                const WallParameters        &wall_parameters,
                const StaticStageParameters &parameters,
                ConditionalOStream          &log);

    /// Collective. Throws RunError where the smallest load step doesn't
    /// converge.
    StaticState<dim>
    run();

    /**
     * Write the result of run() to static.vtu, one file for all ranks:
     * displacement (m), each cell's mean stress (Pa) and volume ratio.
     * Collective.
     */
    void
    write_vtu(const std::string &directory) const;

  private:
    using Vector = DisplacementVector;

    /// Log a load step, and add it to the effort.
    void
    count(const double load_share, const NewtonResult &result);
    void
    accept(Vector &increment);
    StaticState<dim>
    make_state() const;

    const Scene<dim>                 &scene;
    const StaticStageParameters &parameters;
    ConditionalOStream          &log;

    const FilledGrid<dim>    grid;
    const std::unique_ptr<Equilibrium<dim>> equilibrium;
    WallContact<dim>         contact;
    NewtonSolver<dim>        solver;
    Vector              displacement; ///< since the unloaded state
    StaticEffort effort;
  };
} // namespace Sandglass

#endif
