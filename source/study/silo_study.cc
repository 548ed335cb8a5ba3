#include <sandglass/base/exceptions.h>
#include <sandglass/base/parameter_entries.h>
#include <sandglass/output/output_directory.h>
#include <sandglass/study/silo_study.h>

#include <iomanip>
#include <sstream>

namespace Sandglass
{
  using namespace dealii;

  namespace
  {
    /// Refuse scenes that have no flow rate, or of which the program can't make
    /// variants.
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
  } // namespace



  SiloStudy::SiloStudy(Parameters          &parameters,
                       const CommandLine   &command_line,
                       const ParameterFile &file,
                       const MPI_Comm       communicator,
                       const std::string   &name)
    : parameters(parameters)
    , command_line(command_line)
    , file(file)
    , communicator(communicator)
    , directory(parameters.output.directory)
    , log(communicator,
          command_line.is_quiet ? Log::Screen::nothing :
                                  Log::Screen::everything)
  {
    check_flowing_silo(parameters.scene, name);
  }



  RunResult
  SiloStudy::run_in(const std::string              &subdirectory,
                    const std::vector<std::string> &warnings) const
  {
    set_parameter("Output", "Directory", directory + "/" + subdirectory);
    CommandLine run_only = command_line;
    run_only.task        = CommandLine::Task::run;
    Log run_log(communicator,
                command_line.is_quiet ? Log::Screen::nothing :
                                        Log::Screen::progress);
    return *run(parameters, run_only, warnings, communicator, run_log);
  }



  void
  SiloStudy::write_results()
  {
    write_results("running", "");
  }



  void
  SiloStudy::write_results(const std::string &status,
                           const std::string &message)
  {
    do_and_share_errors(communicator, [&]() {
      if (Utilities::MPI::this_mpi_process(communicator) != 0)
        return;
      // The first run has made the directory.
      if (!has_log_file)
        log.open_file(directory + "/sandglass.log", false);
      has_log_file = true;
      write(status, message);
    });
  }



  void
  SiloStudy::fail(const std::string &what)
  {
    const std::string message = run_in_words() + ": " + what;
    write_results("failed", message);
    log.record_error(message);
    throw RunError(message);
  }



  void
  SiloStudy::perform()
  {
    try
      {
        make_runs();
      }
    catch (const RunError &error)
      {
        fail(error.what());
      }
    catch (const InputError &error)
      {
        // Only the first run has written nothing yet.
        if (!has_results())
          throw;
        fail(error.what());
      }
    write_results("finished", "");
    log.stream() << conclusion() << "Results are in " << directory << std::endl;
  }



  std::string
  short_text(const double value)
  {
    std::ostringstream text;
    text << std::setprecision(3) << value;
    return text.str();
  }
} // namespace Sandglass
