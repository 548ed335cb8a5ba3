#ifndef sandglass_base_number_text_h
#define sandglass_base_number_text_h

#include <sstream>
#include <string>

namespace Sandglass
{
  /// A number as messages show it, with six digits at most.
  inline std::string
  number_text(const double number)
  {
    std::ostringstream text;
    text << number;
    return text.str();
  }
} // namespace Sandglass

#endif
