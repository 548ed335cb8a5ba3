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
        for (const auto &column : columns)
          append(column);
        end_row();
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
  CsvFile::append(const double value)
  {
    append(to_text(value));
  }



  void
  CsvFile::append(const unsigned long value)
  {
    append(std::to_string(value));
  }



  void
  CsvFile::append(const std::string_view &value)
  {
    if (!row.empty())
      row += ',';
    row += value;
  }



  void
  CsvFile::end_row()
  {
    row += '\n';
    file << row;
    size += row.size();
    row.clear();
  }



  void
  CsvFile::flush()
  {
    if (!file.flush())
      throw RunError("'" + filename + "' can't be written. Is the disk full?");
  }
} // namespace Sandglass
