#include <sandglass/base/exceptions.h>
#include <sandglass/report/page.h>

#include <boost/program_options.hpp>

#include <fstream>
#include <iostream>

namespace
{
  namespace options = boost::program_options;
  using namespace Sandglass;

  constexpr int failed = 1, input_refused = 2;

  constexpr const char *usage =
    "usage: sandglass-report DIRECTORY\n\n"
    "Writes report.html into DIRECTORY, the output directory of a run of\n"
    "sandglass, also while that goes on or after it has failed: one file, which\n"
    "a browser shows without a network.\n";



  /// Empty if only help was asked for.
  std::string
  parse_directory(const int argc, const char *const argv[])
  {
    options::options_description visible;
    visible.add_options()("help,h", "");
    visible.add_options()("directory", options::value<std::string>());
    options::positional_options_description positional;
    positional.add("directory", 1);
    try
      {
        options::variables_map values;
        options::store(options::command_line_parser(argc, argv)
                         .options(visible)
                         .positional(positional)
                         .run(),
                       values);
        if (values.count("help"))
          return "";
        if (values.count("directory") &&
            !values["directory"].as<std::string>().empty())
          return values["directory"].as<std::string>();
      }
    catch (const options::error &error)
      {
        throw InputError(std::string(error.what()) + "\n" + usage);
      }
    throw InputError(std::string("which directory?\n") + usage);
  }



  /// Under another name first, so that no half page is ever there.
  std::filesystem::path
  write_report(const Report::RunDirectory &run)
  {
    const std::string page  = Report::make_page(run);
    const auto        file  = run.path / "report.html";
    const auto        draft = run.path / "report.html.new";
    std::ofstream     stream(draft, std::ios::binary);
    stream << page;
    stream.close();
    if (!stream)
      {
        std::error_code ignored;
        std::filesystem::remove(draft, ignored);
        throw RunError("'" + file.string() +
                       "' can't be written. Is the disk full, or the directory "
                       "not yours?");
      }
    std::filesystem::rename(draft, file);
    return file;
  }
} // namespace



int
main(int argc, char *argv[])
{
  try
    {
      const std::string directory = parse_directory(argc, argv);
      if (directory.empty())
        std::cout << usage;
      else
        std::cout << write_report(Report::RunDirectory(directory)).string()
                  << std::endl;
      return 0;
    }
  catch (const Sandglass::InputError &error)
    {
      std::cerr << "sandglass-report: " << error.what() << std::endl;
      return input_refused;
    }
  catch (const std::exception &error)
    {
      std::cerr << "sandglass-report: " << error.what() << std::endl;
      return failed;
    }
}
