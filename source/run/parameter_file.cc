#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <sandglass/run/parameter_file.h>
#include <sandglass/run/settings_without_effect.h>

#include <algorithm>
#include <regex>
#include <sstream>

namespace Sandglass
{
  using namespace dealii;

  namespace
  {
    /// Rank 0 reads; errors are thrown on each rank.
    std::vector<ParameterLine>
    read_lines(const std::string &filename, const MPI_Comm communicator)
    {
      std::pair<std::string, std::vector<ParameterLine>> result;
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
        try
          {
            result.second = read_parameter_lines(filename);
          }
        catch (const InputError &error)
          {
            result.first = error.what();
          }
      if (Utilities::MPI::n_mpi_processes(communicator) > 1)
        result = Utilities::MPI::broadcast(communicator, result);
      if (!result.first.empty())
        throw InputError(result.first);
      return result.second;
    }



    std::string
    with_single_blanks(const std::string &text)
    {
      return std::regex_replace(text, std::regex("\\s+"), " ");
    }



    std::string
    joined(const std::vector<std::string> &sections)
    {
      std::string result;
      for (const std::string &name : sections)
        result += (result.empty() ? "" : "/") + name;
      return result;
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
  {
    scan(read_lines(filename, communicator));
    sets_something =
      std::any_of(entries.begin(), entries.end(), [](const Entry &entry) {
        return !entry.name.empty();
      });
    for (const std::string &setting : settings)
      add_setting(setting);
  }



  void
  ParameterFile::scan(const std::vector<ParameterLine> &lines)
  {
    const std::regex subsection_line("subsection\\s+(.*)", std::regex::icase);
    const std::regex end_line("end\\s*(#.*)?", std::regex::icase);
    const std::regex set_line("set\\s+([^=]*[^=\\s])\\s*=\\s*(.*)",
                              std::regex::icase);

    // The open subsections, and where they begin.
    std::vector<std::string> sections, places;
    for (const ParameterLine &line : lines)
      {
        std::smatch match;
        const auto  fault = [&line](const std::string &what) {
          return InputError(line.place + ": '" + line.text +
                            "' can't be understood: " + what);
        };
        if (std::regex_match(line.text, match, subsection_line))
          {
            const std::string name = match[1];
            sections.push_back(with_single_blanks(
              Utilities::trim(name.substr(0, name.find('#')))));
            places.push_back(line.place);
            entries.push_back({joined(sections), "", "", line.place});
          }
        else if (std::regex_match(line.text, match, end_line))
          {
            if (sections.empty())
              throw fault("no subsection is open");
            sections.pop_back();
            places.pop_back();
          }
        else if (std::regex_match(line.text, match, set_line))
          entries.push_back({joined(sections),
                             with_single_blanks(match[1]),
                             match[2],
                             line.place});
        else
          throw fault("allowed are lines with 'subsection NAME', 'end', 'set "
                      "NAME = VALUE' and 'include FILE'");
      }
    if (!sections.empty())
      throw InputError(places.back() + ": 'subsection " + sections.back() +
                       "' can't be understood: it has no 'end'");
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
       "-s '" + setting + "'",
       true});
  }



  void
  ParameterFile::parse(ParameterHandler &prm) const
  {
    // In their order: later ones override earlier ones.
    for (const Entry &entry : entries)
      if (!entry.name.empty())
        set_entry(entry, prm);
    for (const Entry &entry : entries)
      if (entry.name.empty() &&
          !prm.subsection_path_exists(
            Utilities::split_string_list(entry.section, '/')))
        throw InputError(
          entry.place + ": there is no section '" + entry.section +
          "'; sandglass --print-parameters lists what is allowed");
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
    for (const std::string &value :
         {entry.value,
          // A comment may begin within a word, where the word makes no sense.
          Utilities::trim(entry.value.substr(0, entry.value.find('#')))})
      try
        {
          allowed.clear();
          prm.set(entry.name, value);
          break;
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



  std::vector<std::string>
  ParameterFile::warnings(const ParameterHandler &prm) const
  {
    std::vector<std::string> result = settings_without_effect(prm);
    if (!sets_something)
      result.push_back(filename + " sets no parameter: all that the command "
                                  "line doesn't set have their defaults.");
    return result;
  }



  bool
  ParameterFile::is_on_command_line(const std::string &section,
                                    const std::string &name) const
  {
    return std::any_of(entries.begin(),
                       entries.end(),
                       [&section, &name](const Entry &entry) {
                         return entry.is_on_command_line &&
                                entry.section == section && entry.name == name;
                       });
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
