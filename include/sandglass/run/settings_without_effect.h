#ifndef sandglass_run_settings_without_effect_h
#define sandglass_run_settings_without_effect_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /// A warning for each parameter that differs from its default, but that
  /// nothing reads with the other choices made: that names what it would need.
  std::vector<std::string>
  settings_without_effect(const dealii::ParameterHandler &prm);
} // namespace Sandglass

#endif
