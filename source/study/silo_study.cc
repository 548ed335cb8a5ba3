#include <sandglass/base/exceptions.h>
#include <sandglass/base/parameter_entries.h>
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
                       const std::string   &name,
                       const std::string   &subdirectories)
    : parameters(parameters)
    , command_line(command_line)
    , file(file)
    , communicator(communicator)
    , output(parameters.output.directory, communicator)
    , directory(output.path)
    , log(communicator,
          command_line.is_quiet ? Log::Screen::nothing :
                                  Log::Screen::everything)
    , subdirectories(subdirectories)
  {
    check_flowing_silo(parameters.scene, name);
  }



  void
  SiloStudy::begin()
  {
    if (has_begun)
      return;
    output.start(log);
    output.clear_subdirectories(subdirectories);
    write_results(Status::running, "");
    has_begun = true;
  }



  RunResult
  SiloStudy::run_in(const std::string              &which,
                    const std::vector<std::string> &warnings)
  {
    set_parameter("Output", "Directory", directory + "/" + subdirectory(which));
    CommandLine run_only = command_line;
    run_only.task        = CommandLine::Task::run;
    Log run_log(communicator,
                command_line.is_quiet ? Log::Screen::nothing :
                                        Log::Screen::progress);
    return *run(parameters,
                run_only,
                warnings,
                communicator,
                run_log,
                [this]() { begin(); });
  }



  void
  SiloStudy::write_results()
  {
    write_results(Status::running, "");
  }



  void
  SiloStudy::write_results(const std::string &status,
                           const std::string &message)
  {
    do_and_share_errors(communicator, [&]() {
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
        write(status, message);
    });
  }



  std::string
  SiloStudy::keep_results(const std::string &status, const std::string &what)
  {
    const std::string message = run_in_words() + ": " + what;
    write_results(status, message);
    log.record_error(message);
    return message;
  }



  void
  SiloStudy::fail(const std::string &what)
  {
    throw RunError(keep_results(Status::failed, what));
  }



  void
  SiloStudy::perform()
  {
    try
      {
        make_runs();
      }
    catch (const RunStopped &stop)
      {
        // The run could go on, but the study can't.
        throw RunStopped(keep_results(Status::stopped,
                                      "Stopped by " +
                                        name_of_signal(stop.signal) +
                                        "; the runs before it are kept. A "
                                        "study starts anew."),
                         stop.signal);
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
    write_results(Status::finished, "");
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
