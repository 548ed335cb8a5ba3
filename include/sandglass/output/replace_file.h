#ifndef sandglass_output_replace_file_h
#define sandglass_output_replace_file_h

#include <string>

namespace Sandglass
{
  /**
   * Write a file so that whoever looks, at any moment, finds the old one or
   * the new one, and never a part of it. Throws RunError.
   */
  void
  replace_file(const std::string &filename, const std::string &content);
} // namespace Sandglass

#endif
