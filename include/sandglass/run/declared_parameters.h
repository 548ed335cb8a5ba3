#ifndef sandglass_run_declared_parameters_h
#define sandglass_run_declared_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /// One parameter as a ParameterHandler knows it.
  struct DeclaredParameter
  {
    std::string section; ///< with / between sections
    std::string name;
    std::string value, default_value;
    std::string pattern; ///< what values are allowed, in words
    std::string documentation;
  };

  /// All parameters that have been declared, in this order.
  std::vector<DeclaredParameter>
  declared_parameters(const dealii::ParameterHandler &prm);
} // namespace Sandglass

#endif
