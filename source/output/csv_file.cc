#include <sandglass/base/exceptions.h>
#include <sandglass/output/csv_file.h>
#include <sandglass/output/replace_file.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <filesystem>

namespace Sandglass
{
  std::string
  to_text(const double value)
  {
    if (std::isnan(value))
      return "nan";
    std::array<char, 32> text;
    const auto           result =
      std::to_chars(text.data(), text.data() + text.size(), value);
    return std::string(text.data(), result.ptr);
  }



  namespace
  {
    /// The texts with commas between them, and the line's end.
    std::string
    line_of(const std::vector<std::string> &texts)
    {
      std::string line, separator;
      for (const std::string &text : texts)
        {
          line += separator + text;
          separator = ",";
        }
      return line + '\n';
    }
  } // namespace



  std::string
  csv_line(const std::vector<ColumnValue> &values)
  {
    std::vector<std::string> texts;
    for (const ColumnValue &value : values)
      if (const double *number = std::get_if<double>(&value))
        texts.push_back(to_text(*number));
      else if (const unsigned long *count = std::get_if<unsigned long>(&value))
        texts.push_back(std::to_string(*count));
      else
        texts.push_back(std::get<std::string>(value));
    return line_of(texts);
  }



  CsvFile::CsvFile(const std::string              &filename,
                   const std::vector<std::string> &columns)
    : filename(filename)
    , columns(columns)
  {}



  void
  CsvFile::open()
  {
    if (size == 0)
      {
        file.open(filename, std::ios::trunc);
        write_line(line_of(columns));
      }
    else
      {
        std::filesystem::resize_file(filename, size);
        size_flushed = size;
        file.open(filename, std::ios::app);
      }
    flush();
  }



  void
  CsvFile::refuse_other(const std::string &directory) const
  {
    if (size == 0)
      return;
    const std::string there =
      directory + '/' + std::filesystem::path(filename).filename().string();
    const auto refuse = [&there](const std::string &reason) {
      throw InputError("--restart: '" + there +
                         "' is not the table that the checkpoint belongs to: " +
                         reason +
                         "; allowed is the directory of the checkpoint's run",
                       "Output",
                       "Directory");
    };
    std::error_code error;
    const auto      size_found = std::filesystem::file_size(there, error);
    if (error)
      refuse("it isn't there");
    if (size_found < size)
      refuse("it is shorter");
    std::ifstream table(there);
    std::string   head;
    std::getline(table, head);
    if (head + '\n' != line_of(columns))
      refuse("it has other columns");
  }



  void
  CsvFile::add_row(const std::vector<ColumnValue> &values)
  {
    write_line(csv_line(values));
  }



  void
  CsvFile::write_line(const std::string &line)
  {
    file << line;
    size += line.size();
  }



  void
  CsvFile::flush()
  {
    errno = 0;
    if (file.flush())
      {
        size_flushed = size;
        return;
      }
    const int reason = errno;
    file.close();
    std::error_code ignored;
    std::filesystem::resize_file(filename, size_flushed, ignored);
    errno = reason;
    throw_unwritable(filename);
  }
} // namespace Sandglass
