#ifndef sandglass_run_print_outputs_h
#define sandglass_run_print_outputs_h

#include <string>

namespace Sandglass
{
  /// The fields and columns of all output files, as Markdown for the
  /// documentation: the tables by which they are written.
  std::string
  print_outputs();
} // namespace Sandglass

#endif
