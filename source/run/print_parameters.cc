#include <sandglass/run/parameter_file.h>

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <sstream>

namespace Sandglass
{
  using namespace dealii;

  namespace
  {
    /// deal.II writes characters other than letters and digits as _ and their
    /// hexadecimal code.
    std::string
    demangle(const std::string &name)
    {
      std::string result;
      for (std::size_t i = 0; i < name.size(); ++i)
        if (name[i] == '_' && i + 2 < name.size())
          {
            result +=
              static_cast<char>(std::stoi(name.substr(i + 1, 2), nullptr, 16));
            i += 2;
          }
        else
          result += name[i];
      return result;
    }



    /// Text for a cell of a Markdown table.
    std::string
    table_cell(const std::string &text)
    {
      std::string result;
      for (const char character : text)
        result += character == '|' ? "\\|" : std::string(1, character);
      return result;
    }



    std::string
    print_markdown(const ParameterHandler &prm)
    {
      std::stringstream json;
      prm.print_parameters(json,
                           ParameterHandler::JSON |
                             ParameterHandler::KeepDeclarationOrder);
      boost::property_tree::ptree sections;
      boost::property_tree::read_json(json, sections);

      std::ostringstream text;
      text << "# Parameters\n\nWritten by `sandglass --print-parameters md`.\n";
      for (const auto &[section, parameters] : sections)
        {
          text << "\n## " << demangle(section)
               << "\n\n| Parameter | Default | Allowed | Meaning |\n"
                  "|---|---|---|---|\n";
          for (const auto &[name, parameter] : parameters)
            text << "| " << demangle(name) << " | `"
                 << table_cell(parameter.get<std::string>("default_value"))
                 << "` | "
                 << table_cell(
                      parameter.get<std::string>("pattern_description"))
                 << " | "
                 << table_cell(parameter.get<std::string>("documentation"))
                 << " |\n";
        }
      return text.str();
    }
  } // namespace



  std::string
  print_parameters(const ParameterHandler &prm, const std::string &format)
  {
    if (format == "md")
      return print_markdown(prm);
    std::ostringstream text;
    prm.print_parameters(text,
                         (format == "json" ? ParameterHandler::JSON :
                                             ParameterHandler::PRM) |
                           ParameterHandler::KeepDeclarationOrder);
    return text.str();
  }
} // namespace Sandglass
