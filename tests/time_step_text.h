#ifndef sandglass_tests_time_step_text_h
#define sandglass_tests_time_step_text_h

#include <iomanip>
#include <sstream>
#include <string>

/// What `Particle stage/Time step` has to be for a fixed step in s, without
/// rounding.
inline std::string
time_step_text(const double time_step)
{
  std::ostringstream text;
  text << std::setprecision(17) << time_step;
  return text.str();
}

#endif
