#include <sandglass/base/parameter_entries.h>
#include <sandglass/flow/flow_parameters.h>

namespace Sandglass
{
  FlowParameters::FlowParameters()
    : ParameterAcceptor("Flow")
  {
    add_selection<Method>(
      *this,
      "Method",
      method,
      {{"particle-in-cell", Method::particle_in_cell},
       {"updated Lagrangian", Method::updated_lagrangian}},
      "How the flow is computed: by the explicit particle-in-cell method, or by "
      "updated-Lagrangian finite elements that are meshed anew where they "
      "degrade (triangles only, walls at rest; no speed-up by ranks).");
  }
} // namespace Sandglass
