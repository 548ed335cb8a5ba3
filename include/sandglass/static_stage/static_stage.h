#ifndef sandglass_static_stage_static_stage_h
#define sandglass_static_stage_static_stage_h

#include <deal.II/base/conditional_ostream.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <sandglass/material/material_parameters.h>
#include <sandglass/static_stage/equilibrium.h>
#include <sandglass/static_stage/static_stage_parameters.h>
#include <sandglass/static_stage/static_state.h>
#include <sandglass/static_stage/wall_contact.h>

#include <string>

namespace Sandglass
{
  /**
   * The state at rest under gravity with the outlet closed, by the updated
   * Lagrangian finite element method (paper, Section 5; doc/theory.md).
   *
   * Residuals are l2 norms of the nodal out-of-balance forces over that of the
   * nodal weight.
   */
  class StaticStage
  {
  public:
    StaticStage(const Scene                 &scene,
                const MaterialParameters    &material_parameters,
                const WallParameters        &wall_parameters,
                const StaticStageParameters &parameters,
                ConditionalOStream          &log);

    /// Throws RunError if even the smallest load step doesn't converge.
    /// Collective.
    StaticState
    run();

    /// Write static.pvtu with displacement and stress. Collective.
    void
    write_vtu(const std::string &directory) const;

  private:
    using Vector = FilledGrid::Vector;

    struct NewtonResult
    {
      bool         has_converged;
      unsigned int n_iterations;
      double       residual;
    };

    /// All state at an iterate; returns the residual.
    double
    evaluate(const Vector &trial_increment, const double load_share);

    NewtonResult
    solve_load_step(const double load_share);

    /// Factor of the Newton step that lowers the residual most, among 1, 1/2,
    /// 1/4 and 1/8, or 0 if none does.
    double
    search_line(const Vector &step, const double residual_norm, const double load_share);

    void
    move_along(const Vector &step, const double factor, Vector &result);

    StaticState
    make_state() const;

    const Scene                 &scene;
    const StaticStageParameters &parameters;
    ConditionalOStream          &log;

    const DruckerPrager material;
    const FilledGrid    grid;
    Equilibrium         equilibrium;
    WallContact         contact;

    TrilinosWrappers::SparseMatrix tangent;
    Vector displacement_before, displacement, increment, forces, residual;
  };
} // namespace Sandglass

#endif
