#include <sandglass/output/csv_file.h>
#include <sandglass/output/json_object.h>

#include <cmath>
#include <cstdio>

namespace Sandglass
{
  namespace
  {
    std::string
    quoted(const std::string &text)
    {
      std::string result = "\"";
      for (const char character : text)
        if (character == '"' || character == '\\')
          result += std::string("\\") + character;
        else if (static_cast<unsigned char>(character) < 0x20)
          {
            char code[7];
            std::snprintf(code, sizeof(code), "\\u%04x", character);
            result += code;
          }
        else
          result += character;
      return result + '"';
    }
  } // namespace



  void
  JsonObject::add(const std::string &name, const std::string &value)
  {
    add_entry(name, quoted(value));
  }



  void
  JsonObject::add(const std::string &name, const unsigned long value)
  {
    add_entry(name, std::to_string(value));
  }



  void
  JsonObject::add(const std::string &name, const double value)
  {
    add_entry(name, std::isfinite(value) ? to_text(value) : "null");
  }



  std::string
  JsonObject::entry(const std::string &name, const std::string &value)
  {
    return quoted(name) + ": " + quoted(value);
  }



  void
  JsonObject::add_entry(const std::string &name, const std::string &value)
  {
    entries +=
      (entries.empty() ? "\n  " : ",\n  ") + quoted(name) + ": " + value;
  }
} // namespace Sandglass
