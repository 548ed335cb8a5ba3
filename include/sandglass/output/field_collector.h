#ifndef sandglass_output_field_collector_h
#define sandglass_output_field_collector_h

#include <sandglass/base/table.h>
#include <sandglass/output/vtu_file.h>

#include <type_traits>
#include <vector>

namespace Sandglass
{
  /// Fills a table's fields, point by point or cell by cell.
  template <typename Source>
  class FieldCollector
  {
  public:
    /**
     * @param table     has to live as long as this object.
     * @param n_values  how often add() is going to be called.
     */
    FieldCollector(const std::vector<Field<Source>> &table,
                   const std::size_t                 n_values)
      : table(table)
    {
      for (const Field<Source> &field : table)
        result.push_back(std::visit(
          [&](const auto value) { return empty(field.name, value, n_values); },
          field.value));
    }

    void
    add(const Source &source)
    {
      for (unsigned int i = 0; i < table.size(); ++i)
        std::visit(
          [&](const auto value) {
            using Numbers = FieldNumbers<std::decay_t<decltype(value)>>;
            append(std::get<std::vector<typename Numbers::Type>>(
                     result[i].values),
                   value(source));
          },
          table[i].value);
    }

    std::vector<VtuPiece::Field>
    take()
    {
      return std::move(result);
    }

  private:
    template <typename Function>
    static VtuPiece::Field
    empty(const char *name, const Function, const std::size_t n_values)
    {
      using Numbers = FieldNumbers<Function>;
      std::vector<typename Numbers::Type> values;
      values.reserve(Numbers::n * n_values);
      return {name,
              Numbers::n,
              std::move(values),
              Numbers::n == 6 ? VtuPiece::symmetric_tensor_components :
                                std::vector<std::string>()};
    }

    template <typename Number>
    static void
    append(std::vector<Number> &values, const Number value)
    {
      values.push_back(value);
    }

    static void
    append(std::vector<float> &values, const dealii::Tensor<1, 3> &vector)
    {
      for (unsigned int d = 0; d < 3; ++d)
        values.push_back(vector[d]);
    }

    static void
    append(std::vector<float> &values, const std::array<double, 6> &tensor)
    {
      values.insert(values.end(), tensor.begin(), tensor.end());
    }

    const std::vector<Field<Source>> &table;
    std::vector<VtuPiece::Field>      result;
  };
} // namespace Sandglass

#endif
