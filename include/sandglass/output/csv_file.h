#ifndef sandglass_output_csv_file_h
#define sandglass_output_csv_file_h

#include <sandglass/base/table.h>

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace Sandglass
{
  /// The shortest text that reads back as the same number; `nan` for NaN.
  std::string
  to_text(const double value);

  /// A row of a comma separated table, with the line's end.
  std::string
  csv_line(const std::vector<ColumnValue> &values);

  /// A whole table with its head.
  template <typename Source>
  std::string
  csv_text(const std::vector<Column<Source>> &columns,
           const std::vector<Source>         &rows)
  {
    std::vector<ColumnValue> values;
    for (const Column<Source> &column : columns)
      values.push_back(std::string(column.name));
    std::string text = csv_line(values);
    for (const Source &row : rows)
      {
        values.clear();
        for (const Column<Source> &column : columns)
          values.push_back(value_of(column, row));
        text += csv_line(values);
      }
    return text;
  }

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

    /**
     * After deserialization, before open(): throws InputError unless a file of
     * this name in another directory, or in the same one, has what the archive
     * knew of, and these very columns.
     */
    void
    refuse_other(const std::string &directory) const;

    /// One value for each column.
    void
    add_row(const std::vector<ColumnValue> &values);

    /// Bring all rows to the file; where they don't all fit, none of them is
    /// left there in part.
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
    write_line(const std::string &line);

    const std::string              filename;
    const std::vector<std::string> columns;
    std::ofstream                  file;
    std::uint64_t                  size         = 0; ///< in bytes
    std::uint64_t                  size_flushed = 0; ///< likewise
  };

  /// The same with the columns of a table.
  template <typename Source>
  class CsvTable : public CsvFile
  {
  public:
    /// @param example  of the rows' sources, for the columns that the file has.
    CsvTable(const std::string                 &filename,
             const std::vector<Column<Source>> &all_columns,
             const Source                      &example)
      : CsvTable(filename, columns_of(all_columns, example))
    {}

    void
    add_row(const Source &source)
    {
      std::vector<ColumnValue> values;
      for (const Column<Source> &column : columns)
        values.push_back(value_of(column, source));
      CsvFile::add_row(values);
    }

  private:
    CsvTable(const std::string                 &filename,
             const std::vector<Column<Source>> &columns)
      : CsvFile(filename, names(columns))
      , columns(columns)
    {}

    static std::vector<std::string>
    names(const std::vector<Column<Source>> &columns)
    {
      std::vector<std::string> result;
      for (const Column<Source> &column : columns)
        result.emplace_back(column.name);
      return result;
    }

    const std::vector<Column<Source>> columns;
  };
} // namespace Sandglass

#endif
