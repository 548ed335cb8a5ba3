#include <sandglass/base/exceptions.h>
#include <sandglass/report/run_directory.h>
#include <sandglass/report/text_files.h>

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <sstream>

namespace Sandglass
{
  namespace Report
  {
    namespace
    {
      using Tree = boost::property_tree::ptree;

      Tree
      parse_summary(const std::filesystem::path &file, const std::string &text)
      {
        Tree tree;
        try
          {
            std::istringstream stream(text);
            boost::property_tree::read_json(stream, tree);
          }
        catch (const boost::property_tree::json_parser_error &error)
          {
            throw InputError("'" + file.string() + "' is damaged: line " +
                             std::to_string(error.line()) + ": " +
                             error.message() + '.');
          }
        return tree;
      }



      /// A report is of a run, not of a study or an element test.
      void
      check_kind(const std::filesystem::path &path, const Tree &summary)
      {
        if (summary.count("law"))
          throw InputError("'" + path.string() +
                           "' holds an element test; a report is of a run of "
                           "a silo. Draw element_test.csv.");
        if (summary.count("particles"))
          return;
        if (std::filesystem::exists(path / "study.csv"))
          throw InputError("'" + path.string() +
                           "' holds a study. Ask for the report of one of its "
                           "runs, a directory in it.");
      }
    } // namespace



    RunDirectory::RunDirectory(const std::filesystem::path &path)
      : path(path)
    {
      if (!std::filesystem::exists(path))
        throw InputError("'" + path.string() + "' doesn't exist.");
      if (!std::filesystem::is_directory(path))
        throw InputError("'" + path.string() + "' is not a directory.");

      const auto exists = [&path](const char *const name) {
        return std::filesystem::exists(path / name);
      };
      // A run that has just begun has parameters only.
      if (!exists("summary.json") && !exists("parameters.prm"))
        throw InputError("'" + path.string() +
                         "' holds no run: there is neither summary.json nor "
                         "parameters.prm in it.");

      for (const char *const name :
           {"summary.json", "parameters.prm", "sandglass.log"})
        if (exists(name))
          texts[name] = read_text(path / name);
      if (const auto summary = texts.find("summary.json");
          summary != texts.end())
        check_kind(path, parse_summary(path / "summary.json", summary->second));

      const std::map<std::string, std::vector<std::string>> tables = {
        {"history.csv", {"time_s"}},
        {"flow_rate.csv",
         {"time_s", "discharged_mass_kg", "mass_flow_rate_kg_per_s"}},
        {"wall_traction.csv",
         {"time_s", "wall", "arc_length_m", "x_m", "y_m", "normal_Pa"}},
        {"wall_envelope.csv", {"wall", "side", "largest_normal_Pa"}},
        {"flow_profile.csv", {"side", "y_m", "mass_flow_index"}},
        {"residence.csv", {"time_s", "layer", "mass_left_kg"}},
        {"gauges.csv", {"time_s", "gauge", "x_m", "y_m", "normal_Pa"}}};
      for (const auto &[name, columns] : tables)
        if (exists(name.c_str()) && std::filesystem::file_size(path / name) > 0)
          texts[name] = read_table(path / name, columns);

      particles = read_pvd(path / "particles.pvd");
      meshes    = read_pvd(path / "grid.pvd");
      walls     = read_pvd(path / "walls.pvd");
    }
  } // namespace Report
} // namespace Sandglass
