#ifndef sandglass_flow_flow_parameters_h
#define sandglass_flow_flow_parameters_h

#include <deal.II/base/parameter_acceptor.h>

namespace Sandglass
{
  /// Section `Flow`: by which method the flow is computed.
  class FlowParameters : public dealii::ParameterAcceptor
  {
  public:
    enum class Method
    {
      particle_in_cell,  ///< explicit (paper, Section 4.4)
      updated_lagrangian ///< finite elements with re-zoning (Section 5.3)
    };

    FlowParameters();

    Method method = Method::particle_in_cell;
  };
} // namespace Sandglass

#endif
