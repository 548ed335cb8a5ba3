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
  class StaticStage
  {
  public:
    StaticStage(const Scene                 &scene,
                const MaterialParameters    &material_parameters,
                const WallParameters        &wall_parameters,
                const StaticStageParameters &parameters,
                ConditionalOStream          &log);

    StaticState
    run();

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

    double
    evaluate(const Vector &trial_increment, const double load_share);
    NewtonResult
    solve_load_step(const double load_share);

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
