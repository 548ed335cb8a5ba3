#include <sandglass/output/flow_profile.h>

namespace Sandglass
{
  // In three dimensions no wall is beside another in a line, and none is
  // compared yet.
  template <>
  std::vector<FlowBand>
  flow_bands<3>(const Scene<3> &)
  {
    return {};
  }
} // namespace Sandglass
