#include <sandglass/choices/all_kinematics.h>
#include <sandglass/output/banner.h>
#include <sandglass/run/run.h>
#include <sandglass/run/simulation.h>

namespace Sandglass
{
  std::optional<RunResult>
  run(const Parameters               &parameters,
      const CommandLine              &command_line,
      const std::vector<std::string> &warnings,
      const MPI_Comm                  communicator,
      Log                            &log,
      const std::function<void()>    &before_writing)
  {
    const bool only_checks = command_line.task == CommandLine::Task::validate;
    std::optional<RunResult>       result;
    std::optional<OutputDirectory> directory;
    if (!only_checks)
      {
        log.stream() << banner(communicator) << std::flush;
        directory.emplace(parameters.output.directory, communicator);
      }
    log.warn(warnings);
    choose(
      AllKinematics(),
      [&parameters](const auto kinematics) {
        return decltype(kinematics)::Type::formulation ==
               parameters.scene.formulation;
      },
      [&](const auto kinematics) {
        constexpr int   dim = decltype(kinematics)::Type::dim;
        Simulation<dim> simulation(parameters, command_line, communicator, log);
        if (directory)
          result.emplace(simulation.run(*directory, before_writing));
      });
    return result;
  }
} // namespace Sandglass
