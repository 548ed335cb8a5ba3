#ifndef sandglass_run_command_line_h
#define sandglass_run_command_line_h

#include <string>
#include <vector>

namespace Sandglass
{
  /// What the user asks for on the command line.
  struct CommandLine
  {
    enum class Task
    {
      run,
      validate,
      study,
      element_test,
      print_parameters,
      print_outputs,
      print_help,
      print_version
    };

    Task                     task = Task::run;
    std::string              study; ///< its name
    std::string              parameter_file;
    std::vector<std::string> settings;         ///< "Section/Name=value"
    std::string              output_directory; ///< empty: the parameter file's
    std::string              print_format = "prm";
    bool                     is_restart   = false;
    std::string              restart_from; ///< empty: the output directory
    bool                     is_quiet = false;
  };

  /// Throws InputError that names the option.
  CommandLine
  parse_command_line(const int argc, const char *const argv[]);

  /// The text of --help.
  std::string
  command_line_help();
} // namespace Sandglass

#endif
