#ifndef sandglass_flow_updated_lagrangian_updated_lagrangian_parameters_h
#define sandglass_flow_updated_lagrangian_updated_lagrangian_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <sandglass/flow/updated_lagrangian/newmark_inertia.h>

namespace Sandglass
{
  /// Section `Updated Lagrangian stage`: motion by finite elements.
  class UpdatedLagrangianParameters : public dealii::ParameterAcceptor
  {
  public:
    UpdatedLagrangianParameters();

    double            time_step = 0.01; ///< the longest, in s
    NewmarkParameters newmark;
    unsigned int      element_order = 2;
    /// Newton stops when the residual is below this share of the forces.
    double relative_residual = 1e-6;
  };
} // namespace Sandglass

#endif
