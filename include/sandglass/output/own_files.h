#ifndef sandglass_output_own_files_h
#define sandglass_output_own_files_h

#include <filesystem>
#include <string>
#include <vector>

namespace Sandglass
{
  /// What becomes of a file when another run starts in its directory, or goes
  /// on from there in another directory.
  enum class OwnFile
  {
    result,   ///< goes; a run that goes on takes it along
    leftover, ///< goes: it says something of the old run only
    none      ///< stays: it is the user's
  };

  /**
   * The one table of the names that the program gives to files in an output
   * directory. A new kind of output needs an entry, or its files would outlive
   * their run.
   *
   * @param name  of a file in the output directory or, behind `vtu/`, in the
   *              directory of the fields.
   */
  OwnFile
  own_file(const std::string &name);

  /// The subdirectory for the fields.
  inline const std::string field_directory = "vtu";

  /// The names of a directory's files that are of this kind, as own_file()
  /// takes them. Throws std::filesystem::filesystem_error.
  std::vector<std::string>
  own_files(const std::string &directory, const OwnFile kind);
} // namespace Sandglass

#endif
