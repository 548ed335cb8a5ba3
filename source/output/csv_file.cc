#include <sandglass/base/exceptions.h>
#include <sandglass/output/csv_file.h>

#include <array>
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
        write_line(columns);
      }
    else
      {
        std::error_code error;
        const auto size_found = std::filesystem::file_size(filename, error);
        if (error || size_found < size)
          throw RunError("'" + filename +
                         "' is not the file that the checkpoint belongs to. "
                         "Run again without --restart.");
        std::filesystem::resize_file(filename, size);
        file.open(filename, std::ios::app);
      }
    flush();
  }



  void
  CsvFile::add_row(const std::vector<ColumnValue> &values)
  {
    std::vector<std::string> texts;
    for (const ColumnValue &value : values)
      if (const double *number = std::get_if<double>(&value))
        texts.push_back(to_text(*number));
      else if (const unsigned long *count = std::get_if<unsigned long>(&value))
        texts.push_back(std::to_string(*count));
      else
        texts.push_back(std::get<std::string>(value));
    write_line(texts);
  }



  void
  CsvFile::write_line(const std::vector<std::string> &texts)
  {
    std::string line, separator;
    for (const std::string &text : texts)
      {
        line += separator + text;
        separator = ",";
      }
    line += '\n';
    file << line;
    size += line.size();
  }



  void
  CsvFile::flush()
  {
    if (!file.flush())
      throw RunError("'" + filename + "' can't be written. Is the disk full?");
  }
} // namespace Sandglass
