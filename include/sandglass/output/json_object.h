#ifndef sandglass_output_json_object_h
#define sandglass_output_json_object_h

#include <sandglass/base/table.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /// Collects names and values in the text of a JSON object.
  class JsonObject
  {
  public:
    void
    add(const std::string &name, const std::string &value);
    void
    add(const std::string &name, const unsigned long value);
    /// What isn't a finite number becomes null.
    void
    add(const std::string &name, const double value);

    /// The keys of a table that such a source has.
    template <typename Source>
    void
    add(const std::vector<Column<Source>> &keys, const Source &source)
    {
      for (const Column<Source> &key : columns_of(keys, source))
        std::visit([&](const auto &value) { add(key.name, value); },
                   value_of(key, source));
    }

    std::string
    text() const
    {
      return "{" + entries + "\n}\n";
    }

    /// One entry as it stands in the text.
    static std::string
    entry(const std::string &name, const std::string &value);

  private:
    void
    add_entry(const std::string &name, const std::string &value);

    std::string entries;
  };
} // namespace Sandglass

#endif
