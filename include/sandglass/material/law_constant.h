#ifndef sandglass_material_law_constant_h
#define sandglass_material_law_constant_h

#include <sandglass/material/material_constants.h>

#include <cstring>

namespace Sandglass
{
  /**
   * A constant of a law beside those that all laws have. A law lists its own in
   * `law_constants`; the parameter `Law constants`, its checks and its
   * documentation walk the list.
   */
  struct LawConstant
  {
    const char *name; ///< in the parameter
    const char *unit; ///< SI; "1" for pure numbers
    double      default_value;
    double      smallest, largest; ///< both allowed
    const char *meaning;
  };

  /// The value of one of a law's constants: the user's, or its default.
  template <typename Law>
  double
  law_constant(const MaterialConstants &constants, const char *const name)
  {
    const auto given = constants.law_constants.find(name);
    if (given != constants.law_constants.end())
      return given->second;
    for (const LawConstant &constant : Law::law_constants)
      if (std::strcmp(constant.name, name) == 0)
        return constant.default_value;
    return 0.;
  }
} // namespace Sandglass

#endif
