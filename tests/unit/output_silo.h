#ifndef tests_unit_output_silo_h
#define tests_unit_output_silo_h

#include <sandglass/output/log.h>
#include <sandglass/output/observers.h>
#include <sandglass/output/output_directory.h>
#include <sandglass/scene/make_mesh.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace Sandglass
{
  /**
   * Parameters of a small plane silo, for the tests to change. The output
   * directory is the same on the ranks of the communicator, and goes in the
   * end.
   */
  struct SmallSilo
  {
    explicit SmallSilo(const MPI_Comm     communicator = MPI_COMM_SELF,
                       const std::string &name         = "")
      : communicator(communicator)
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

    ~SmallSilo()
    {
      remove_directory();
    }

    /// A path that no other test uses at the same time.
    static std::string
    unique_path()
    {
      const auto *test = testing::UnitTest::GetInstance()->current_test_info();
      return testing::TempDir() + "sandglass_" + test->test_suite_name() + '_' +
             test->name() + '_' + std::to_string(getpid());
    }

    SceneParameters         scene;
    MaterialParameters      material;
    WallParameters          walls;
    ParticleStageParameters stage;
    OutputParameters        output;
    const MPI_Comm          communicator;

  private:
    void
    remove_directory() const
    {
      std::error_code ignored;
      MPI_Barrier(communicator);
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
        std::filesystem::remove_all(output.directory, ignored);
      MPI_Barrier(communicator);
    }
  };



  /// The scene and the particles of a small silo, and what observes them.
  struct SmallRun
  {
    explicit SmallRun(SmallSilo &silo)
      : silo(silo)
      , scene(make_mesh(silo.scene, silo.communicator),
              silo.scene.formulation,
              silo.scene.particles_per_cell,
              silo.scene.gravity,
              silo.communicator)
      , log(silo.communicator, true)
      , timings(log.stream(), TimerOutput::never, TimerOutput::wall_times)
      , observers(silo.output,
                  scene,
                  silo.material,
                  silo.walls,
                  silo.stage.end_time,
                  log,
                  timings)
    {
      silo.stage.check();
      stage = make_particle_stage(scene, silo.material, silo.walls, silo.stage);
    }

    /// Run from the start to `end_time`, or if that is less, to the end.
    void
    run(const double       end_time     = 1e300,
        const StaticState<2> *static_state = nullptr)
    {
      prepare_output_directory(silo.output, false, silo.communicator, log);
      observers.start(*stage, static_state);
      go_on(end_time);
    }

    /// Go on from the checkpoint in the output directory to the end.
    void
    resume()
    {
      const Checkpoint checkpoint =
        read_checkpoint(silo.output.directory, settings());
      prepare_output_directory(silo.output, true, silo.communicator, log);
      observers.resume(*stage, checkpoint);
      go_on(1e300);
    }

    std::vector<Checkpoint::Setting>
    settings() const
    {
      return checkpoint_settings(scene, silo.material, silo.walls, silo.stage);
    }

    void
    go_on(const double end_time)
    {
      while (!stage->is_finished() && stage->view().clock().time < end_time)
        {
          {
            TimerOutput::Scope scope(timings, Timing::particle_loop);
            stage->step();
          }
          observers.after_step(*stage);
        }
      if (stage->is_finished())
        observers.finish(*stage);
    }

    SmallSilo                     &silo;
    const Scene<2>                    scene;
    Log                            log;
    TimerOutput                    timings;
    Observers                      observers;
    std::unique_ptr<ParticleStage> stage;
  };



  inline std::string
  read_text(const std::string &filename)
  {
    std::ifstream      file(filename);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }



  inline std::vector<std::string>
  read_lines(const std::string &filename)
  {
    std::vector<std::string> lines;
    std::ifstream            file(filename);
    for (std::string line; std::getline(file, line);)
      lines.push_back(line);
    return lines;
  }



  /// The numbers of one line of a table.
  inline std::vector<double>
  read_numbers(const std::string &line)
  {
    std::vector<double> numbers;
    std::istringstream  stream(line);
    for (std::string number; std::getline(stream, number, ',');)
      numbers.push_back(std::strtod(number.c_str(), nullptr));
    return numbers;
  }
} // namespace Sandglass

#endif
