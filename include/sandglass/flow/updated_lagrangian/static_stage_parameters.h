#ifndef sandglass_flow_updated_lagrangian_static_stage_parameters_h
#define sandglass_flow_updated_lagrangian_static_stage_parameters_h

#include <deal.II/base/parameter_acceptor.h>

namespace Sandglass
{
  /// Section `Static stage`: how the state at rest is found.
  class StaticStageParameters : public dealii::ParameterAcceptor
  {
  public:
    StaticStageParameters();

    /// Whether there is a static stage; without it, material starts unstressed
    /// and undisplaced.
    bool is_enabled = true;
    /// Whether particles start from where the load has moved them.
    bool displaces_particles = false;
    /// Whether particles settle before the flow where none can leave.
    bool         settles_particles = true;
    unsigned int n_load_steps      = 5;
    /// Newton stops when the residual is below this share of the weight.
    double       relative_residual  = 1e-10;
    unsigned int maximum_iterations = 100;
    /// Relaxation stops when the residual is below this share of the weight.
    double       relaxed_residual         = 1e-6;
    unsigned int maximum_relaxation_steps = 20000;
    /// Shares of the whole load below which a load step is not cut further.
    double smallest_load_step = 1e-3;
    /// Most unknowns for the direct solver; beyond that, tangents are inverted
    /// by multigrid.
    unsigned int most_direct_unknowns = 20000;
  };
} // namespace Sandglass

#endif
