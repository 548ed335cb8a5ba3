#include <sandglass/base/exceptions.h>
#include <sandglass/output/replace_file.h>

#include <filesystem>
#include <fstream>

namespace Sandglass
{
  void
  replace_file(const std::string &filename, const std::string &content)
  {
    const std::string temporary_name = filename + ".new";
    std::ofstream     file(temporary_name, std::ios::binary);
    file << content;
    file.close();
    std::error_code error;
    if (file)
      std::filesystem::rename(temporary_name, filename, error);
    if (!file || error)
      throw RunError("'" + filename + "' can't be written. Is the disk full?");
  }
} // namespace Sandglass
