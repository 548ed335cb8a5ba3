#ifndef sandglass_output_replace_file_h
#define sandglass_output_replace_file_h

#include <string>

namespace Sandglass
{
  /// Whether a file has to survive the machine, too, and not the process only;
  /// that takes the time of the disk.
  enum class Survives
  {
    process,
    machine
  };

  /**
   * Write a file so that whoever looks, at any moment, finds the old one or
   * the new one, and never a part of it. Throws RunError, and the old one is
   * there then.
   */
  void
  replace_file(const std::string &filename,
               const std::string &content,
               const Survives     survives = Survives::process);

  /// The name under which such a file is written before it is complete.
  std::string
  unfinished_name(const std::string &filename);

  /// To be called right behind the failure. Throws RunError, which says that
  /// the disk is full where it is, and otherwise what the system says.
  [[noreturn]] void
  throw_unwritable(const std::string &filename);
} // namespace Sandglass

#endif
