#ifndef sandglass_material_law_failure_h
#define sandglass_material_law_failure_h

#include <stdexcept>

namespace Sandglass
{
  /**
   * A law could not find the stress at the end of an increment. The message
   * names the law, the stress before, the strain increment and the state
   * variables; whoever knows the particle, the place and the time adds them.
   */
  class LawFailure : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;

    /// Which of the particles side by side it was.
    unsigned int lane = 0;
  };
} // namespace Sandglass

#endif
