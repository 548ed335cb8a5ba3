#include <sandglass/base/exceptions.h>
#include <sandglass/run/command_line.h>

#include <boost/program_options.hpp>

#include <sstream>

namespace Sandglass
{
  namespace
  {
    namespace options = boost::program_options;

    options::options_description
    visible_options()
    {
      options::options_description description("Options");
      auto                         add = description.add_options();
      add("set,s",
          options::value<std::vector<std::string>>()->composing()->value_name(
            "Section/Name=value"),
          "set a parameter; overrides the file");
      add("output,o",
          options::value<std::string>()->value_name("DIRECTORY"),
          "where to write results; overrides Output/Directory");
      add("restart", "go on from the output directory's checkpoint");
      add("restart-from",
          options::value<std::string>()->value_name("PATH"),
          "go on from the checkpoint in another directory, or from a certain "
          "checkpoint, such as DIRECTORY/checkpoint-before.bin");
      add("quiet", "print errors only");
      add("validate", "read and check the parameters and the mesh, then stop");
      add("study",
          options::value<std::string>()->value_name("NAME"),
          "run the scene several times: convergence, on a sequence of meshes, "
          "for its flow rate and how sure that is; smallest-outlet, with "
          "several outlets, for the one from which on the material flows");
      add("element-test",
          "put the law alone through the test of the section Element test");
      add("print-parameters",
          options::value<std::string>()->implicit_value("prm")->value_name(
            "prm|md|json"),
          "print all parameters with defaults and documentation");
      add("print-outputs",
          "print a table of each output file's fields and columns");
      add("help", "print this text");
      add("version", "print the versions of Sandglass and its libraries");
      return description;
    }

    /// What to do with a parameter file. Throws InputError where options don't
    /// go together.
    CommandLine::Task
    task_of(const options::variables_map &values)
    {
      const auto is_given = [&values](const std::string &option) {
        return values.count(option) > 0;
      };
      if (!is_given("study") && !is_given("element-test"))
        return is_given("validate") ? CommandLine::Task::validate :
                                      CommandLine::Task::run;
      const std::string task = is_given("study") ? "study" : "element-test";
      for (const std::string option :
           {"element-test", "validate", "restart", "restart-from"})
        if (option != task && is_given(option))
          throw InputError("Command line: --" + task + " and --" + option +
                           " don't go together; allowed is one of the two");
      return is_given("study") ? CommandLine::Task::study :
                                 CommandLine::Task::element_test;
    }

    /// A directory or file that has to have a name; empty without the option.
    /// Throws InputError.
    std::string
    path(const options::variables_map &values, const std::string &option)
    {
      if (values.count(option) == 0)
        return "";
      const std::string result = values[option].as<std::string>();
      if (result.empty())
        throw InputError("Command line: --" + option +
                         " ''; allowed is the name of a directory" +
                         (option == "output" ? "" : " or of a checkpoint"));
      return result;
    }

    CommandLine
    interpret(const options::variables_map &values)
    {
      CommandLine result;
      using Task = CommandLine::Task;
      if (values.count("help") > 0)
        result.task = Task::print_help;
      else if (values.count("version") > 0)
        result.task = Task::print_version;
      else if (values.count("print-parameters") > 0)
        {
          result.task         = Task::print_parameters;
          result.print_format = values["print-parameters"].as<std::string>();
          if (result.print_format != "prm" && result.print_format != "md" &&
              result.print_format != "json")
            throw InputError("--print-parameters " + result.print_format +
                             ": allowed are prm, md and json");
        }
      else if (values.count("print-outputs") > 0)
        result.task = Task::print_outputs;
      else
        {
          if (values.count("file") == 0)
            throw InputError("No parameter file given.\n" +
                             command_line_help());
          result.task = task_of(values);
          if (result.task == Task::study)
            result.study = values["study"].as<std::string>();
          result.parameter_file = values["file"].as<std::string>();
        }
      if (values.count("set") > 0)
        result.settings = values["set"].as<std::vector<std::string>>();
      result.output_directory = path(values, "output");
      result.restart_from     = path(values, "restart-from");
      result.is_restart =
        values.count("restart") > 0 || !result.restart_from.empty();
      result.is_quiet = values.count("quiet") > 0;
      return result;
    }
  } // namespace



  std::string
  command_line_help()
  {
    std::ostringstream text;
    text << "Usage: sandglass FILE.prm [-s \"Section/Name=value\"]... "
            "[-o DIRECTORY] [--restart | --restart-from PATH] [--quiet]\n"
            "       sandglass --validate FILE.prm\n"
            "       sandglass --study convergence|smallest-outlet FILE.prm\n"
            "       sandglass --element-test FILE.prm\n"
            "       sandglass --print-parameters [prm|md|json]\n"
            "       sandglass --print-outputs\n"
            "       mpirun -n N sandglass FILE.prm\n\n"
         << visible_options()
         << "\nExit code: 0 done, 1 the run failed, 2 the input was refused, "
            "130 or 143\nSIGINT or SIGTERM stopped the run, which --restart "
            "goes on with.";
    return text.str();
  }



  CommandLine
  parse_command_line(const int argc, const char *const argv[])
  {
    options::options_description all = visible_options();
    all.add_options()("file", options::value<std::string>());
    options::positional_options_description positional;
    positional.add("file", 1);

    options::variables_map values;
    try
      {
        options::store(options::command_line_parser(argc, argv)
                         .options(all)
                         .positional(positional)
                         .run(),
                       values);
      }
    catch (const options::error &error)
      {
        throw InputError("Command line: " + std::string(error.what()) +
                         "; sandglass --help lists what is allowed");
      }
    return interpret(values);
  }
} // namespace Sandglass
