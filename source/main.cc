#include <deal.II/base/mpi.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/element_test/run_element_test.h>
#include <sandglass/output/banner.h>
#include <sandglass/output/output_directory.h>
#include <sandglass/run/parameter_file.h>
#include <sandglass/run/print_outputs.h>
#include <sandglass/run/run.h>
#include <sandglass/study/study.h>

#include <iostream>

namespace
{
  using namespace Sandglass;

  constexpr int run_failed = 1, input_refused = 2;

  /// Read and check the parameters and the mesh, then run, once or for a
  /// study, unless only this was asked for. An element test needs no mesh.
  void
  validate_and_run(const CommandLine &command_line, const MPI_Comm communicator)
  {
    const Study *const study = command_line.task == CommandLine::Task::study ?
                                 &find_study(command_line.study) :
                                 nullptr;
    auto               settings = command_line.settings;
    if (!command_line.output_directory.empty())
      settings.push_back("Output/Directory=" + command_line.output_directory);

    Parameters          parameters;
    const ParameterFile file(command_line.parameter_file,
                             settings,
                             communicator);
    file.parse(dealii::ParameterAcceptor::prm);
    try
      {
        parameters.check();
        Log log(communicator,
                command_line.is_quiet ? Log::Screen::nothing :
                                        Log::Screen::everything);
        if (command_line.task == CommandLine::Task::element_test)
          run_element_test(parameters,
                           file.warnings(dealii::ParameterAcceptor::prm),
                           communicator,
                           log);
        else if (study != nullptr)
          study->perform(parameters, command_line, file, communicator);
        else
          {
            parameters.fix_resolution();
            run(parameters,
                command_line,
                file.warnings(dealii::ParameterAcceptor::prm),
                communicator,
                log);
          }
      }
    catch (const InputError &error)
      {
        throw file.located(error);
      }
  }



  void
  execute(const int argc, const char *const argv[], const bool prints)
  {
    using Task                     = CommandLine::Task;
    const CommandLine command_line = parse_command_line(argc, argv);
    switch (command_line.task)
      {
        case Task::print_help:
          if (prints)
            std::cout << command_line_help() << std::endl;
          break;
        case Task::print_version:
          if (prints)
            std::cout << banner(MPI_COMM_WORLD) << std::flush;
          break;
        case Task::print_parameters:
          {
            const Parameters parameters;
            if (prints)
              std::cout << print_parameters(dealii::ParameterAcceptor::prm,
                                            command_line.print_format)
                        << std::flush;
            break;
          }
        case Task::print_outputs:
          if (prints)
            std::cout << print_outputs() << std::flush;
          break;
        default:
          validate_and_run(command_line, MPI_COMM_WORLD);
      }
  }
} // namespace



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool                               prints =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  try
    {
      execute(argc, argv, prints);
      return 0;
    }
  catch (const Sandglass::InputError &error)
    {
      if (prints)
        std::cerr << error.what() << std::endl;
      return input_refused;
    }
  catch (const Sandglass::RunStopped &stop)
    {
      if (prints)
        std::cerr << stop.what() << std::endl;
      return stop.exit_code();
    }
  catch (const std::exception &error)
    {
      // Errors other than RunError may be on one rank only: each rank prints.
      const bool is_collective =
        dynamic_cast<const Sandglass::RunError *>(&error) != nullptr;
      if (prints || !is_collective)
        std::cerr << Sandglass::message_of(error) << std::endl;
      if (!is_collective &&
          dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
        MPI_Abort(MPI_COMM_WORLD, run_failed);
      return run_failed;
    }
}
