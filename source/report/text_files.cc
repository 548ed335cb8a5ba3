#include <sandglass/base/exceptions.h>
#include <sandglass/report/text_files.h>

#include <boost/algorithm/string.hpp>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace Sandglass
{
  namespace Report
  {
    std::string
    read_text(const std::filesystem::path &file)
    {
      std::ifstream      stream(file, std::ios::binary);
      std::ostringstream text;
      text << stream.rdbuf();
      if (!stream || (text.str().empty() && std::filesystem::file_size(file)))
        throw InputError("'" + file.string() + "' can't be read.");
      return text.str();
    }



    namespace
    {
      std::vector<std::string>
      split(const std::string &line)
      {
        std::vector<std::string> values;
        boost::split(values, line, boost::is_any_of(","));
        return values;
      }
    } // namespace



    std::string
    read_table(const std::filesystem::path    &file,
               const std::vector<std::string> &needed)
    {
      std::string text = read_text(file);
      text.erase(text.rfind('\n') + 1); // npos + 1 is 0

      std::istringstream lines(text);
      std::string        line;
      std::getline(lines, line);
      const auto columns = split(line);
      for (const std::string &name : needed)
        if (std::find(columns.begin(), columns.end(), name) == columns.end())
          throw InputError("'" + file.string() + "' has no column '" + name +
                           "': it is damaged, or of another program.");
      for (unsigned int number = 2; std::getline(lines, line); ++number)
        if (const auto n = split(line).size(); n != columns.size())
          throw InputError("'" + file.string() + "' is damaged: line " +
                           std::to_string(number) + " has " +
                           std::to_string(n) + " values for " +
                           std::to_string(columns.size()) + " columns.");
      return text;
    }



    std::string
    parameter(const std::string &parameter_file,
              const std::string &section,
              const std::string &name)
    {
      std::istringstream lines(parameter_file);
      std::string        line, inside;
      while (std::getline(lines, line))
        {
          line.erase(std::find(line.begin(), line.end(), '#'), line.end());
          boost::trim(line);
          if (boost::starts_with(line, "subsection "))
            inside = boost::trim_copy(line.substr(11));
          const auto equals = line.find('=');
          if (inside == section && boost::starts_with(line, "set ") &&
              equals != std::string::npos &&
              boost::trim_copy(line.substr(4, equals - 4)) == name)
            return boost::trim_copy(line.substr(equals + 1));
        }
      return "";
    }
  } // namespace Report
} // namespace Sandglass
