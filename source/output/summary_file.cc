#include <sandglass/base/exceptions.h>
#include <sandglass/output/json_object.h>
#include <sandglass/output/replace_file.h>
#include <sandglass/output/summary_file.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace Sandglass
{
  namespace
  {
    /// In the blocks that the old file has.
    bool
    write_over(const std::string &filename, const std::string &text)
    {
      std::fstream file(filename, std::ios::in | std::ios::out);
      if (!(file << text << std::flush))
        return false;
      std::error_code error;
      std::filesystem::resize_file(filename, text.size(), error);
      return !error;
    }
  } // namespace



  std::string
  summary_file(const std::string &directory)
  {
    return directory + "/summary.json";
  }



  void
  write_summary_file(const std::string &directory, const std::string &text)
  {
    const std::string filename = summary_file(directory);
    try
      {
        replace_file(filename, text);
      }
    catch (const RunError &)
      {
        if (!write_over(filename, text))
          throw;
      }
  }



  void
  amend_summary_file(const std::string &directory,
                     const std::string &status,
                     const std::string &message,
                     const unsigned int rank)
  {
    std::ostringstream old_text;
    old_text << std::ifstream(summary_file(directory)).rdbuf();
    std::string       text     = old_text.str();
    const std::string old_line = JsonObject::entry("status", Status::running);
    const auto        position = text.find(old_line);
    if (position == std::string::npos)
      return;
    text.replace(position,
                 old_line.size(),
                 JsonObject::entry("status", status) + ",\n  " +
                   JsonObject::entry("message", message));
    // Several ranks may do so at once.
    const std::string own_file =
      summary_file(directory) + '.' + std::to_string(rank);
    replace_file(own_file, text);
    std::filesystem::rename(own_file, summary_file(directory));
  }
} // namespace Sandglass
