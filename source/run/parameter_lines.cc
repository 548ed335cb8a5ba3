#include <deal.II/base/utilities.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/run/parameter_lines.h>

#include <boost/locale/encoding_utf.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace Sandglass
{
  using dealii::Utilities::trim;

  namespace
  {
    std::string
    read_bytes(const std::string &filename)
    {
      std::ifstream      file(filename, std::ios::binary);
      std::ostringstream text;
      // Reading a directory fails only here.
      if (!file || !(text << file.rdbuf()))
        throw InputError("the parameter file can't be read, or it is empty; "
                         "allowed is the path of a .prm file "
                         "(sandglass --print-parameters writes one)");
      return text.str();
    }



    /// The text of bytes in UTF-8 or, where a byte order mark says so, UTF-16.
    std::string
    decode(const std::string &bytes)
    {
      const auto begins_with = [&bytes](const std::string &mark) {
        return bytes.compare(0, mark.size(), mark) == 0;
      };
      if (begins_with("\xEF\xBB\xBF"))
        return bytes.substr(3);
      const bool is_little_endian = begins_with("\xFF\xFE");
      if (!is_little_endian && !begins_with("\xFE\xFF"))
        return bytes;
      std::u16string text;
      for (std::size_t i = 2; i + 1 < bytes.size(); i += 2)
        {
          const auto low  = static_cast<unsigned char>(bytes[i]);
          const auto high = static_cast<unsigned char>(bytes[i + 1]);
          text.push_back(is_little_endian ? low + 256 * high :
                                            high + 256 * low);
        }
      return boost::locale::conv::utf_to_utf<char>(text);
    }



    /// The text with the ends of lines that Unix has.
    std::string
    with_plain_ends(const std::string &text)
    {
      return std::regex_replace(text, std::regex("\r\n?"), "\n");
    }



    std::string
    without_comment(const std::string &line)
    {
      const auto is_blank = [&line](const std::size_t i) {
        return i >= line.size() ||
               std::isspace(static_cast<unsigned char>(line[i])) != 0;
      };
      for (std::size_t i = 0; i < line.size(); ++i)
        if (line[i] == '#' && (i == 0 || is_blank(i - 1) || is_blank(i + 1)))
          return trim(line.substr(0, i));
      return trim(line);
    }



    /// Reads a file and those that it includes.
    class Reader
    {
    public:
      void
      read(const std::string &filename)
      {
        const auto fault = [&filename](const std::string &what) {
          return InputError(filename + ": " + what);
        };
        std::string text;
        try
          {
            text = with_plain_ends(decode(read_bytes(filename)));
          }
        catch (const InputError &error)
          {
            throw fault(error.what());
          }
        if (text.find('\0') != std::string::npos)
          throw fault("the file is not a text; allowed are UTF-8, and UTF-16 "
                      "with a byte order mark");
        open_files.push_back(std::filesystem::weakly_canonical(filename));
        read_lines(filename, text);
        open_files.pop_back();
      }

      std::vector<ParameterLine> lines;

    private:
      void
      read_lines(const std::string &filename, const std::string &text)
      {
        std::istringstream stream(text);
        std::string        line;
        ParameterLine      whole;
        bool               goes_on = false;
        for (unsigned int number = 1; std::getline(stream, line); ++number)
          {
            line = without_comment(line);
            if (!goes_on)
              whole = {"", filename + ':' + std::to_string(number)};
            goes_on = !line.empty() && line.back() == '\\';
            if (goes_on)
              line.pop_back();
            whole.text += line;
            if (!goes_on)
              add(whole, filename);
          }
        if (goes_on)
          throw InputError(whole.place +
                           ": the line ends with \\, but none follows; allowed "
                           "is \\ where the next line goes on with this one");
      }

      void
      add(const ParameterLine &line, const std::string &filename)
      {
        static const std::regex include("include\\s+(.*)", std::regex::icase);
        std::smatch             match;
        if (std::regex_match(line.text, match, include))
          include_file(line, match[1], filename);
        else if (!line.text.empty())
          lines.push_back(line);
      }

      void
      include_file(const ParameterLine &line,
                   std::string          name,
                   const std::string   &filename)
      {
        if (name.size() > 1 && name.front() == '"' && name.back() == '"')
          name = name.substr(1, name.size() - 2);
        const auto path  = std::filesystem::path(filename).parent_path() / name;
        const auto fault = [&line](const std::string &what) {
          return InputError(line.place + ": include '" + what);
        };
        if (!std::filesystem::is_regular_file(path))
          throw fault(name + "': there is no such file; allowed is a path "
                             "relative to the file with the include");
        if (std::count(open_files.begin(),
                       open_files.end(),
                       std::filesystem::weakly_canonical(path)) > 0)
          throw fault(name + "': the file includes itself");
        read(path.string());
      }

      /// Those that are being read: each includes the next.
      std::vector<std::filesystem::path> open_files;
    };
  } // namespace



  std::vector<ParameterLine>
  read_parameter_lines(const std::string &filename)
  {
    Reader reader;
    reader.read(filename);
    return reader.lines;
  }
} // namespace Sandglass
