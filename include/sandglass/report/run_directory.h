#ifndef sandglass_report_run_directory_h
#define sandglass_report_run_directory_h

#include <sandglass/report/field_files.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace Sandglass
{
  namespace Report
  {
    /// What a run has left in its output directory so far.
    struct RunDirectory
    {
      /**
       * Throws InputError if there is no such directory, no run of a silo in
       * it, or something damaged.
       */
      explicit RunDirectory(const std::filesystem::path &path);

      std::filesystem::path              path;
      std::map<std::string, std::string> texts; // by the file's name
      std::vector<FieldFile>             particles, meshes, walls;
    };
  } // namespace Report
} // namespace Sandglass

#endif
