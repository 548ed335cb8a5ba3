#include <sandglass/run/declared_parameters.h>
#include <sandglass/run/fingerprint.h>
#include <sandglass/run/markdown.h>
#include <sandglass/run/parameter_file.h>

#include <sstream>

namespace Sandglass
{
  using namespace dealii;

  namespace
  {
    std::string
    print_markdown(const ParameterHandler &prm)
    {
      std::ostringstream text;
      text << "# Parameters\n\nWritten by `sandglass --print-parameters md`.\n";
      const auto  parameters = declared_parameters(prm);
      std::string section;
      for (const DeclaredParameter &parameter : parameters)
        {
          if (parameter.section != section)
            text << "\n## " << parameter.section << "\n\n"
                 << markdown_head(
                      {"Parameter", "Default", "Allowed", "Meaning"});
          section = parameter.section;
          text << markdown_row({parameter.name,
                                '`' + parameter.default_value + '`',
                                parameter.pattern,
                                parameter.documentation});
        }
      text << "\n## Free to change on a restart\n\n"
              "`End time` to one later than the checkpoint's time. With a "
              "change of any other parameter `--restart` is refused.\n\n";
      for (const DeclaredParameter &parameter : parameters)
        if (is_free_on_restart(parameter.section, parameter.name))
          text << "- " << parameter.section << '/' << parameter.name << '\n';
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
