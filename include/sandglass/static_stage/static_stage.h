#ifndef sandglass_static_stage_static_stage_h
#define sandglass_static_stage_static_stage_h

#include <deal.II/base/conditional_ostream.h>

#include <sandglass/material/material_parameters.h>
#include <sandglass/static_stage/equilibrium.h>
#include <sandglass/static_stage/newton_solver.h>
#include <sandglass/static_stage/static_stage_parameters.h>
#include <sandglass/static_stage/static_state.h>
#include <sandglass/static_stage/wall_contact.h>

#include <string>

namespace Sandglass
{
  /**
   * The state at rest under gravity with the outlet closed, by the updated
   * Lagrangian finite element method (paper, Section 5; doc/theory.md): load
   * steps of NewtonSolver, cut where they don't converge.
   */
  class StaticStage
  {
  public:
    /// Logs the number of unknowns, and one line per load step.
    StaticStage(const Scene                 &scene,
                const MaterialParameters    &material_parameters,
                const WallParameters        &wall_parameters,
                const StaticStageParameters &parameters,
                ConditionalOStream          &log);

    /// Collective. Throws RunError where the smallest load step doesn't
    /// converge.
    StaticState
    run();

    /**
     * Write the result of run() to static.vtu, one file for all ranks:
     * displacement (m), each cell's mean stress (Pa) and volume ratio.
     * Collective.
     */
    void
    write_vtu(const std::string &directory) const;

  private:
    using Vector = FilledGrid::Vector;

    /// Log a load step, and add it to the effort.
    void
    count(const double load_share, const NewtonSolver::Result &result);
    void
    accept(Vector &increment);
    StaticState
    make_state() const;

    const Scene                 &scene;
    const StaticStageParameters &parameters;
    ConditionalOStream          &log;

    const DruckerPrager material;
    const FilledGrid    grid;
    Equilibrium         equilibrium;
    WallContact         contact;
    NewtonSolver        solver;
    Vector              displacement; ///< since the unloaded state
    StaticState::Effort effort;
  };
} // namespace Sandglass

#endif
