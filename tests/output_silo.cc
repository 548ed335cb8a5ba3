#include "output_silo.h"

#include <sandglass/output/output_directory.h>
#include <sandglass/scene/make_mesh.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace Sandglass
{
  namespace
  {
    const Parameters &
    checked_parameters(SmallSilo &silo)
    {
      silo.stage.check();
      return silo.parameters;
    }
  } // namespace



  SmallSilo::SmallSilo(const MPI_Comm communicator, const std::string &name)
    : communicator(communicator)
    , scene(parameters.scene)
    , material(parameters.material)
    , walls(parameters.walls)
    , stage(parameters.particle_stage)
    , output(parameters.output)
  {
    scene.half_width         = 0.4;
    scene.wall_height        = 0.8;
    scene.outlet_half_width  = 0.2;
    scene.fall_region_depth  = 0.1;
    scene.element_size       = 0.1;
    stage.time_step_text     = "5e-4";
    output.progress_interval = 0.;
    output.directory =
      Utilities::MPI::broadcast(communicator, unique_path() + name);
    remove_directory();
  }



  SmallSilo::~SmallSilo()
  {
    remove_directory();
  }



  std::string
  SmallSilo::unique_path()
  {
    const auto *test = testing::UnitTest::GetInstance()->current_test_info();
    return testing::TempDir() + "sandglass_" + test->test_suite_name() + '_' +
           test->name() + '_' + std::to_string(getpid());
  }



  void
  SmallSilo::set(const std::string &section,
                 const std::string &name,
                 const std::string &value)
  {
    auto &prm = ParameterAcceptor::prm;
    prm.enter_subsection(section);
    prm.set(name, value);
    prm.leave_subsection();
  }



  void
  SmallSilo::remove_directory() const
  {
    std::error_code ignored;
    MPI_Barrier(communicator);
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      std::filesystem::remove_all(output.directory, ignored);
    MPI_Barrier(communicator);
  }



  SmallRun::SmallRun(SmallSilo &silo)
    : silo(silo)
    , log(silo.communicator, Log::Screen::nothing)
    , timings(log.stream(), TimerOutput::never, TimerOutput::wall_times)
    , mesh(make_mesh<2>(silo.scene, silo.communicator))
    , fingerprint(ParameterAcceptor::prm, mesh)
    , checkpoints(silo.output, fingerprint, timings)
    , part(checked_parameters(silo),
           mesh,
           {},
           {},
           silo.communicator,
           log,
           timings)
    , scene(part.scene)
    , observers(part.observers)
    , flow(*part.flow)
  {}



  const FlowView &
  SmallRun::view() const
  {
    return flow.view();
  }



  void
  SmallRun::run(const double end_time, const AtRest *at_rest)
  {
    OutputDirectory(silo.output.directory, silo.communicator).start(log);
    observers.begin(view());
    observers.start(view(), at_rest);
    go_on(end_time);
  }



  void
  SmallRun::resume()
  {
    go_on_from(find_checkpoint());
    go_on(1e300);
  }



  Checkpoint
  SmallRun::find_checkpoint() const
  {
    return read_checkpoint(CheckpointPlace(silo.output.directory),
                           fingerprint,
                           silo.stage.end_time);
  }



  void
  SmallRun::go_on_from(const Checkpoint &checkpoint)
  {
    const std::string &directory = silo.output.directory;
    part.observers.refuse_other_tables(checkpoint.observers, directory);
    OutputDirectory(directory, silo.communicator).go_on(directory, log);
    part.go_on_from(checkpoint);
    checkpoints.pass(checkpoint.time);
  }



  void
  SmallRun::go_on(const double end_time)
  {
    while (!flow.is_finished() && view().clock().time < end_time)
      {
        {
          TimerOutput::Scope scope(timings, Timing::particle_loop);
          flow.step();
        }
        observers.after_step(view());
        checkpoints.after_step(part);
      }
    if (!flow.is_finished())
      return;
    observers.observe_end(view());
    observers.finish();
    checkpoints.at_end(part);
  }



  std::string
  read_text(const std::string &filename)
  {
    std::ifstream      file(filename);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }



  std::vector<std::string>
  read_lines(const std::string &filename)
  {
    std::vector<std::string> lines;
    std::ifstream            file(filename);
    for (std::string line; std::getline(file, line);)
      lines.push_back(line);
    return lines;
  }



  std::vector<double>
  read_numbers(const std::string &line)
  {
    std::vector<double> numbers;
    std::istringstream  stream(line);
    for (std::string number; std::getline(stream, number, ',');)
      numbers.push_back(std::strtod(number.c_str(), nullptr));
    return numbers;
  }
} // namespace Sandglass
