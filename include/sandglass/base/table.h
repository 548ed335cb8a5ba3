#ifndef sandglass_base_table_h
#define sandglass_base_table_h

#include <deal.II/base/tensor.h>

#include <array>
#include <cstdint>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

/**
 * @file
 * Rows of the tables that say what output there is: the writers, the files'
 * headers and the documentation walk the same rows, so that something new in a
 * file is one row.
 */

namespace Sandglass
{
  /**
   * A column of a .csv file, or a key of a .json file.
   *
   * @tparam Source  what its values are read from.
   */
  template <typename Source>
  struct Column
  {
    const char *name;
    const char *unit; ///< SI; "1" for pure numbers, "" for texts
    std::variant<double (*)(const Source &),
                 unsigned long (*)(const Source &),
                 std::string (*)(const Source &)>
                value;
    const char *meaning;
    /// Whether the file has it, which is the same for all rows of a file; none:
    /// always.
    bool (*is_there)(const Source &) = nullptr;
  };

  /// What stands in one column of one row.
  using ColumnValue = std::variant<double, unsigned long, std::string>;

  template <typename Source>
  ColumnValue
  value_of(const Column<Source> &column, const Source &source)
  {
    return std::visit(
      [&source](const auto value) { return ColumnValue(value(source)); },
      column.value);
  }

  /// The columns that the file of such sources has.
  template <typename Source>
  std::vector<Column<Source>>
  columns_of(const std::vector<Column<Source>> &all, const Source &source)
  {
    std::vector<Column<Source>> result;
    for (const Column<Source> &column : all)
      if (column.is_there == nullptr || column.is_there(source))
        result.push_back(column);
    return result;
  }

  /**
   * A field on points or cells of a .vtu file. Its value's type says how many
   * components it has and which numbers are written: vectors and symmetric
   * tensors (in ParaView's order, see Component) as single precision.
   *
   * @tparam Source  what a point's or a cell's value is read from.
   */
  template <typename Source>
  struct Field
  {
    const char *name;
    const char *unit; ///< SI; "1" for pure numbers
    std::variant<float (*)(const Source &),
                 double (*)(const Source &),
                 std::int64_t (*)(const Source &),
                 std::int32_t (*)(const Source &),
                 dealii::Tensor<1, 3> (*)(const Source &),
                 std::array<double, 6> (*)(const Source &)>
                value;
    const char *meaning;
  };

  /// Numbers that a field's function of this type gives: their type in the
  /// file, and how many.
  template <typename Function>
  struct FieldNumbers;

  template <typename Number, typename Source>
  struct FieldNumbers<Number (*)(const Source &)>
  {
    using Type = Number;

    static constexpr unsigned int n = 1;
  };

  template <typename Source>
  struct FieldNumbers<dealii::Tensor<1, 3> (*)(const Source &)>
  {
    using Type = float;

    static constexpr unsigned int n = 3;
  };

  template <typename Source>
  struct FieldNumbers<std::array<double, 6> (*)(const Source &)>
  {
    using Type = float;

    static constexpr unsigned int n = 6;
  };

  template <typename Source>
  unsigned int
  n_components(const Field<Source> &field)
  {
    return std::visit(
      [](const auto value) {
        return FieldNumbers<std::decay_t<decltype(value)>>::n;
      },
      field.value);
  }
} // namespace Sandglass

#endif
