#include <sandglass/output/own_files.h>

#include <regex>

namespace Sandglass
{
  namespace
  {
    struct OwnName
    {
      const char *pattern;
      OwnFile     kind;
    };

    constexpr OwnName own_names[] = {
      {"(particles|grid|walls)\\.pvd", OwnFile::result},
      {"vtu/(particles|grid|walls)_[0-9]{5,}(\\.[0-9]{4,})?\\.p?vtu",
       OwnFile::result},
      {"static\\.vtu", OwnFile::result},
      {"(history|flow_rate|wall_traction|wall_envelope|flow_profile|residence|"
       "gauges)\\.csv",
       OwnFile::result},
      {"residence\\.vtu", OwnFile::result},
      {"summary\\.json(\\.[0-9]+)?", OwnFile::leftover},
      {"sandglass\\.log", OwnFile::leftover},
      {"parameters\\.prm", OwnFile::leftover},
      {"checkpoint(-before)?\\.bin", OwnFile::leftover},
      {"element_test\\.csv", OwnFile::leftover},
      {"study\\.(csv|svg)", OwnFile::leftover},
      {"report\\.html", OwnFile::leftover},
      // What a killed run has left unfinished, see replace_file().
      {"[a-z_]+(-before)?\\.(pvd|csv|vtu|json(\\.[0-9]+)?|prm|bin|svg|html)\\.new",
       OwnFile::leftover}};



    void
    add_files(const std::filesystem::path &directory,
              const std::string           &prefix,
              const OwnFile                kind,
              std::vector<std::string>    &names)
    {
      if (!std::filesystem::is_directory(directory))
        return;
      for (const auto &entry : std::filesystem::directory_iterator(directory))
        {
          const std::string name = prefix + entry.path().filename().string();
          if (own_file(name) == kind && !entry.is_directory())
            names.push_back(name);
        }
    }
  } // namespace



  OwnFile
  own_file(const std::string &name)
  {
    static const std::vector<std::regex> patterns = []() {
      std::vector<std::regex> result;
      for (const OwnName &own : own_names)
        result.emplace_back(own.pattern);
      return result;
    }();
    for (unsigned int i = 0; i < patterns.size(); ++i)
      if (std::regex_match(name, patterns[i]))
        return own_names[i].kind;
    return OwnFile::none;
  }



  std::vector<std::string>
  own_files(const std::string &directory, const OwnFile kind)
  {
    std::vector<std::string> names;
    add_files(directory, "", kind, names);
    add_files(directory + '/' + field_directory,
              field_directory + '/',
              kind,
              names);
    return names;
  }
} // namespace Sandglass
