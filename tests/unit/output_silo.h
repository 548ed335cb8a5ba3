#ifndef tests_unit_output_silo_h
#define tests_unit_output_silo_h

#include <sandglass/observers/log.h>
#include <sandglass/observers/observers.h>
#include <sandglass/observers/output_directory.h>
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
  /// Parameters of a small plane silo, for the tests to change.
  struct SmallSilo
  {
    SmallSilo()
    {
      scene.half_width         = 0.4;
      scene.wall_height        = 0.8;
      scene.outlet_half_width  = 0.2;
      scene.fall_region_depth  = 0.1;
      scene.element_size       = 0.1;
      stage.time_step_text     = "5e-4";
      output.progress_interval = 0.;
      output.directory = testing::TempDir() + "sandglass_output_" + test_name();
      std::filesystem::remove_all(output.directory);
    }

    ~SmallSilo()
    {
      std::error_code ignored;
      std::filesystem::remove_all(output.directory, ignored);
    }

    static std::string
    test_name()
    {
      const auto *test = testing::UnitTest::GetInstance()->current_test_info();
      return std::string(test->test_suite_name()) + '_' + test->name() + '_' +
             std::to_string(getpid());
    }

    SceneParameters         scene;
    MaterialParameters      material;
    WallParameters          walls;
    ParticleStageParameters stage;
    OutputParameters        output;
  };



  /// The scene and the particles of a small silo.
  struct SmallRun
  {
    explicit SmallRun(SmallSilo &silo)
      : silo(silo)
      , scene(make_mesh(silo.scene, MPI_COMM_SELF),
              silo.scene.formulation,
              silo.scene.particles_per_cell,
              silo.scene.gravity,
              MPI_COMM_SELF)
    {
      silo.stage.check();
      stage = make_particle_stage(scene, silo.material, silo.walls, silo.stage);
    }

    /// Run to the end time, observed.
    void
    run(const std::vector<WallForce> *static_wall_forces = nullptr)
    {
      Log         log(MPI_COMM_SELF, true);
      TimerOutput timings(log.stream(),
                          TimerOutput::never,
                          TimerOutput::wall_times);
      prepare_output_directory(silo.output, false, MPI_COMM_SELF, log);
      Observers observers(silo.output,
                          scene,
                          silo.material,
                          silo.walls,
                          silo.stage.end_time,
                          log,
                          timings);
      observers.start(*stage, static_wall_forces);
      while (!stage->is_finished())
        {
          {
            TimerOutput::Scope scope(timings, Timing::particle_loop);
            stage->step();
          }
          observers.after_step(*stage);
        }
      observers.finish(*stage);
    }

    SmallSilo                     &silo;
    const Scene                    scene;
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
