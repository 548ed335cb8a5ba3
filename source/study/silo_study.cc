#include <sandglass/base/exceptions.h>
#include <sandglass/base/parameter_entries.h>
#include <sandglass/study/silo_study.h>

#include <iomanip>
#include <sstream>

namespace Sandglass
{
  void
  check_flowing_silo(const SceneParameters &scene, const std::string &study)
  {
    if (scene.shape != SceneParameters::Shape::silo)
      throw InputError("Scene",
                       "Shape",
                       "mesh file",
                       "allowed is silo with --study " + study +
                         ", which makes several meshes");
    if (!scene.outlet_is_open)
      throw InputError("Scene",
                       "Outlet",
                       "closed",
                       "allowed is open with --study " + study +
                         ", which is about the flow rate");
    if (scene.gravity_vector<2>().norm() == 0.)
      throw InputError("Scene",
                       "Gravity",
                       "0, 0",
                       "allowed is a gravity that makes material flow with "
                       "--study " +
                         study);
  }



  RunResult
  run_variant(const Parameters               &parameters,
              const CommandLine              &command_line,
              const std::string              &directory,
              const std::vector<std::string> &warnings,
              const MPI_Comm                  communicator)
  {
    set_parameter("Output", "Directory", directory);
    CommandLine run_only = command_line;
    run_only.task        = CommandLine::Task::run;
    Log log(communicator,
            command_line.is_quiet ? Log::Screen::nothing :
                                    Log::Screen::progress);
    return *run(parameters, run_only, warnings, communicator, log);
  }



  std::string
  short_text(const double value)
  {
    std::ostringstream text;
    text << std::setprecision(3) << value;
    return text.str();
  }
} // namespace Sandglass
