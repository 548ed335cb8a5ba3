#include <sandglass/scene/resolution.h>

#include <cmath>
#include <sstream>

namespace Sandglass
{
  std::string
  to_text(const Resolution &resolution)
  {
    std::ostringstream text;
    text.precision(3);
    if (!std::isnan(resolution.element_size))
      text << resolution.element_size << " m large, ";
    if (resolution.is_graded())
      text << resolution.outlet_element_size << " m at the outlet's lip, ";
    text << resolution.particles_per_cell << " particles in each";
    return text.str();
  }
} // namespace Sandglass
