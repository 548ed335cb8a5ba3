#ifndef sandglass_report_text_files_h
#define sandglass_report_text_files_h

#include <filesystem>
#include <string>
#include <vector>

namespace Sandglass
{
  namespace Report
  {
    /// What the file holds. Throws InputError if it can't be read.
    std::string
    read_text(const std::filesystem::path &file);

    /**
     * The table of a CSV file with a line of column names, among them those
     * `needed`. A last row without its end of line, which a run may just be
     * writing, is left out. Throws InputError where a column is missing or a
     * row has another number of values than there are columns.
     */
    std::string
    read_table(const std::filesystem::path    &file,
               const std::vector<std::string> &needed);

    /**
     * The value of `name` in `section` of a parameter file as deal.II writes
     * it, with sections that are not nested; empty if there is none.
     */
    std::string
    parameter(const std::string &parameter_file,
              const std::string &section,
              const std::string &name);
  } // namespace Report
} // namespace Sandglass

#endif
