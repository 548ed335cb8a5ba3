#ifndef sandglass_output_csv_file_h
#define sandglass_output_csv_file_h

#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace Sandglass
{
  /// The shortest text that reads back as the same number; `nan` for NaN.
  std::string
  to_text(const double value);

  /**
   * A comma separated table in a file, which one rank writes. Throws RunError
   * when it can't.
   */
  class CsvFile
  {
  public:
    CsvFile(const std::string              &filename,
            const std::vector<std::string> &columns);

    /**
     * Start the file; after deserialization, go on behind the rows that the
     * archive knew of.
     */
    void
    open();

    /// Numbers and texts, one for each column.
    template <typename... Values>
    void
    add_row(const Values &...values)
    {
      (append(values), ...);
      end_row();
    }

    /// Bring all rows to the file.
    void
    flush();

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &size;
    }

  private:
    void
    append(const double value);
    void
    append(const unsigned long value);
    void
    append(const std::string_view &value);
    void
    end_row();

    const std::string              filename;
    const std::vector<std::string> columns;
    std::ofstream                  file;
    std::string                    row;
    std::uint64_t                  size = 0; ///< in bytes
  };
} // namespace Sandglass

#endif
