#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <sandglass/run/parameter_file.h>

#include <fstream>
#include <regex>
#include <sstream>

namespace Sandglass
{
  using namespace dealii;

  namespace
  {
    std::string
    read_file(const std::string &filename, const MPI_Comm communicator)
    {
      std::pair<bool, std::string> result(false, "");
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
        {
          std::ifstream      file(filename);
          std::ostringstream text;
          // Reading a directory fails only here.
          result.first  = file && (text << file.rdbuf());
          result.second = text.str();
        }
      if (Utilities::MPI::n_mpi_processes(communicator) > 1)
        result = Utilities::MPI::broadcast(communicator, result);
      if (!result.first)
        throw InputError(filename +
                         ": the parameter file can't be read, or it is empty; "
                         "allowed is the path of a .prm file "
                         "(sandglass --print-parameters writes one)");
      return result.second;
    }



    /// An exception's own text on one line; deal.II breaks it into several.
    std::string
    info_of(const ExceptionBase &exception)
    {
      std::ostringstream info;
      exception.print_info(info);
      return std::regex_replace(Utilities::trim(info.str()),
                                std::regex("\\s+"),
                                " ");
    }



    /// The pattern's description, which deal.II has only in its exception.
    std::string
    allowed_values(const ExceptionBase &exception)
    {
      const std::string info = info_of(exception);
      std::smatch       match;
      return std::regex_search(info, match, std::regex("pattern[^<]*<(.*)>")) ?
               match[1].str() :
               info;
    }
  } // namespace



  ParameterFile::ParameterFile(const std::string              &filename,
                               const std::vector<std::string> &settings,
                               const MPI_Comm                  communicator)
    : filename(filename)
    , text(read_file(filename, communicator))
  {
    scan_text();
    for (const std::string &setting : settings)
      add_setting(setting);
  }



  void
  ParameterFile::scan_text()
  {
    const std::regex subsection_line("\\s*subsection\\s+(.*\\S)\\s*",
                                     std::regex::icase);
    const std::regex end_line("\\s*end\\s*", std::regex::icase);
    const std::regex set_line("\\s*set\\s+([^=]*[^=\\s])\\s*=\\s*(.*)",
                              std::regex::icase);

    std::vector<std::string> sections;
    std::istringstream       stream(text);
    std::string              line;
    for (unsigned int number = 1; std::getline(stream, line); ++number)
      {
        line = Utilities::trim(line.substr(0, line.find('#')));
        std::smatch match;
        if (std::regex_match(line, match, subsection_line))
          sections.push_back(match[1]);
        else if (std::regex_match(line, match, end_line) && !sections.empty())
          sections.pop_back();
        else if (std::regex_match(line, match, set_line))
          {
            std::string section;
            for (const std::string &name : sections)
              section += (section.empty() ? "" : "/") + name;
            entries.push_back({section,
                               match[1],
                               Utilities::trim(match[2]),
                               filename + ":" + std::to_string(number)});
          }
      }
  }



  void
  ParameterFile::add_setting(const std::string &setting)
  {
    const auto equals = setting.find('=');
    const auto slash  = setting.rfind('/', equals);
    if (equals == std::string::npos || slash == std::string::npos)
      throw InputError("-s '" + setting +
                       "': allowed is \"Section/Name=value\"");
    entries.push_back(
      {Utilities::trim(setting.substr(0, slash)),
       Utilities::trim(setting.substr(slash + 1, equals - slash - 1)),
       Utilities::trim(setting.substr(equals + 1)),
       "-s '" + setting + "'"});
  }



  void
  ParameterFile::parse(ParameterHandler &prm) const
  {
    for (const Entry &entry : entries)
      set_entry(entry, prm);
    // What the scan above doesn't understand, deal.II explains.
    try
      {
        prm.parse_input_from_string(text);
      }
    catch (const ExceptionBase &exception)
      {
        throw InputError(
          filename + ": the file can't be understood: " + info_of(exception));
      }
    // The command line overrides the file.
    for (const Entry &entry : entries)
      set_entry(entry, prm);
  }



  void
  ParameterFile::set_entry(const Entry &entry, ParameterHandler &prm)
  {
    const auto sections = entry.section.empty() ?
                            std::vector<std::string>() :
                            Utilities::split_string_list(entry.section, '/');
    for (const std::string &section : sections)
      prm.enter_subsection(section);
    std::string allowed;
    try
      {
        prm.set(entry.name, entry.value);
      }
    catch (const ParameterHandler::ExcEntryUndeclared &)
      {
        allowed = "there is no such parameter; sandglass --print-parameters "
                  "lists what is allowed";
      }
    catch (const ExceptionBase &exception)
      {
        allowed = "allowed is " + allowed_values(exception);
      }
    for (unsigned int i = 0; i < sections.size(); ++i)
      prm.leave_subsection();
    if (!allowed.empty())
      {
        const InputError error(entry.section, entry.name, entry.value, allowed);
        throw InputError(entry.place + ": " + error.what(),
                         entry.section,
                         entry.name);
      }
  }



  InputError
  ParameterFile::located(const InputError &error) const
  {
    std::string place = filename;
    for (const Entry &entry : entries)
      if (!error.name.empty() && entry.section == error.section &&
          entry.name == error.name)
        place = entry.place;
    return InputError(place + ": " + error.what(), error.section, error.name);
  }
} // namespace Sandglass
