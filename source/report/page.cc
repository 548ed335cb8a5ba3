#include <sandglass/report/mesh_edges.h>
#include <sandglass/report/packing.h>
#include <sandglass/report/page.h>
#include <sandglass/report/particle_frames.h>
#include <sandglass/report/residence_map.h>
#include <sandglass/report/text_files.h>
#include <sandglass/report/wall_cut.h>

#include <sys/auxv.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <stdexcept>

namespace Sandglass
{
  namespace Report
  {
    namespace
    {
      /// Beside the program in the build tree, or where it is installed.
      std::filesystem::path
      template_directory()
      {
        // As the kernel was told it: there need be no /proc.
        const auto program = std::filesystem::canonical(
          reinterpret_cast<const char *>(getauxval(AT_EXECFN)));
        const std::array<std::filesystem::path, 2> places = {
          {program.parent_path() / "share/sandglass/report",
           program.parent_path().parent_path() / "share/sandglass/report"}};
        for (const auto &place : places)
          if (std::filesystem::exists(place / "report.html"))
            return place;
        throw std::runtime_error(
          "The report's templates are neither in '" + places[0].string() +
          "' nor in '" + places[1].string() +
          "'. Install Sandglass as a whole, by cmake --install.");
      }



      /// An element of the page that holds packed bytes.
      std::string
      data_element(const std::string &name, const std::string &packed)
      {
        return "<script type=\"text/plain\" data-file=\"" + escaped(name) +
               "\">" + packed + "</script>\n";
      }



      std::string
      now()
      {
        const auto time = std::chrono::system_clock::to_time_t(
          std::chrono::system_clock::now());
        std::array<char, 32> text;
        std::strftime(text.data(),
                      text.size(),
                      "%Y-%m-%d %H:%M",
                      std::localtime(&time));
        return text.data();
      }



      std::string
      name_of(const std::filesystem::path &directory)
      {
        const auto path = std::filesystem::canonical(directory);
        return path.filename().string();
      }



      std::string
      data_of(const RunDirectory &run)
      {
        std::string data;
        for (const auto &[name, text] : run.texts)
          data += data_element(name, pack(text));

        const auto        prm = run.texts.find("parameters.prm");
        const std::string formulation =
          prm == run.texts.end() ?
            "" :
            parameter(prm->second, "Scene", "Formulation");
        using Space       = ParticleFrames::Space;
        const Space space = formulation == "axisymmetric"     ? Space::round :
                            formulation == "three dimensions" ? Space::body :
                                                                Space::plane;
        const ParticleFrames frames(run.particles, space);
        data += data_element("particles.json", pack(frames.description()));
        data += data_element("particles.bin", pack(frames.bytes()));
        const auto residence = run.path / "residence.vtu";
        if (std::filesystem::exists(residence))
          data +=
            data_element("residence.json", pack(residence_map(residence)));
        if (!run.meshes.empty())
          data += data_element("mesh.json",
                               pack(mesh_edges(
                                 *read_fields(run.meshes.front().file))));
        // The last: an outlet that was closed at the start is no wall of it.
        if (space == Space::body && !run.walls.empty())
          data +=
            data_element("walls.json",
                         pack(wall_cut(*read_fields(run.walls.back().file))));
        return data;
      }



      /// Put `content` where the template names it, as {{name}}.
      void
      fill(std::string       &text,
           const std::string &name,
           const std::string &content)
      {
        const std::string place = "{{" + name + "}}";
        for (auto at = text.find(place); at != std::string::npos;
             at      = text.find(place, at + content.size()))
          text.replace(at, place.size(), content);
      }
    } // namespace



    std::string
    make_page(const RunDirectory &run)
    {
      const auto  templates = template_directory();
      std::string page      = read_text(templates / "report.html");
      fill(page, "name", escaped(name_of(run.path)));
      fill(page, "made", now());
      for (const char *const file : {"report.css",
                                     "d3.min.js",
                                     "d3-licence.txt",
                                     "data.js",
                                     "plot.js",
                                     "movie.js",
                                     "player.js",
                                     "walls.js",
                                     "design.js",
                                     "words.js",
                                     "report.js"})
        fill(page, file, read_text(templates / file));
      fill(page, "data", data_of(run));
      return page;
    }
  } // namespace Report
} // namespace Sandglass
