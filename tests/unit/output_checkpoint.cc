#include <sandglass/base/exceptions.h>
#include <sandglass/flow/particle_in_cell/particle_stage.h>
#include <sandglass/run/checkpoint_files.h>

#include <gtest/gtest.h>

#include <filesystem>

#include "output_silo.h"

using namespace Sandglass;

namespace
{
  /// Observed often, so that averages run when the checkpoint is written.
  void
  observe_often(SmallSilo &silo)
  {
    silo.stage.end_time             = 0.3;
    silo.stage.time_step_text       = "auto";
    silo.output.interval            = 0.04;
    silo.output.checkpoint_interval = 0.15;
  }



  using Stage = ParticleStage<ParticleLayout<2, 4, 0>>;

  /// All numbers of all particles, in the order of the cells.
  std::vector<double>
  state_of_particles(const SmallRun &run)
  {
    const auto &blocks =
      dynamic_cast<const Stage &>(run.flow).particles().blocks();
    std::vector<double> numbers;
    blocks.for_each([&](const ParticleSlot &slot) {
      const auto parcel = blocks.parcel(slot);
      numbers.insert(numbers.end(),
                     {double(parcel.cell),
                      double(parcel.id),
                      parcel.location[0],
                      parcel.location[1],
                      parcel.reference_point[0],
                      parcel.reference_point[1]});
      numbers.insert(numbers.end(),
                     parcel.properties.begin(),
                     parcel.properties.end());
    });
    return numbers;
  }



  /// The lines of a .pvd that list files; its head has the time of day.
  std::vector<std::string>
  data_sets(const std::string &filename)
  {
    std::vector<std::string> lines;
    for (const auto &line : read_lines(filename))
      if (line.find("<DataSet") != std::string::npos)
        lines.push_back(line);
    EXPECT_GT(lines.size(), 5) << filename;
    return lines;
  }



  /// Run a silo in one part and in two.
  ///
  /// @param change  makes it from the small one.
  /// @return the number of particles in the end.
  template <typename Change>
  std::size_t
  expect_the_same_when_resumed(const Change &change)
  {
    SmallSilo whole_silo;
    observe_often(whole_silo);
    change(whole_silo);
    SmallRun whole(whole_silo);
    whole.run();

    SmallSilo silo(MPI_COMM_SELF, "_parts");
    observe_often(silo);
    change(silo);
    {
      SmallRun first_part(silo);
      first_part.run(0.22);
      EXPECT_FALSE(first_part.flow.is_finished());
    }
    SmallRun second_part(silo);
    second_part.resume();

    EXPECT_EQ(second_part.view().clock().step, whole.view().clock().step);
    EXPECT_EQ(state_of_particles(second_part), state_of_particles(whole));
    for (const std::string name :
         {"/history.csv", "/flow_rate.csv", "/wall_traction.csv"})
      EXPECT_EQ(read_text(silo.output.directory + name),
                read_text(whole_silo.output.directory + name))
        << name;
    for (const std::string name : {"/particles.pvd", "/grid.pvd", "/walls.pvd"})
      EXPECT_EQ(data_sets(silo.output.directory + name),
                data_sets(whole_silo.output.directory + name))
        << name;
    // Some was discharged before, and some after the checkpoint.
    EXPECT_GT(second_part.view().totals().mass_removed, 0.);
    return second_part.view().n_particles();
  }



  TEST(Checkpoint, resumed_run_is_the_same_bit_by_bit)
  {
    expect_the_same_when_resumed([](SmallSilo &) {});
  }



  TEST(Checkpoint, resumed_run_is_the_same_with_split_particles)
  {
    const auto graded = [](SmallSilo &silo) {
      silo.scene.outlet_element_size = 0.02;
      silo.stage.time_step_text      = "2e-4";
    };
    const auto unsplit = [&](SmallSilo &silo) {
      graded(silo);
      silo.stage.split_particles = SplitParticles::never;
    };
    EXPECT_GT(expect_the_same_when_resumed(graded),
              expect_the_same_when_resumed(unsplit) + 50);
  }



  TEST(Checkpoint, forgets_what_was_written_after_it)
  {
    SmallSilo silo;
    observe_often(silo);
    SmallRun(silo).run(0.22);
    const std::string history = silo.output.directory + "/history.csv";
    const auto        n_rows  = read_lines(history).size();

    SmallRun         run(silo);
    const Checkpoint checkpoint = run.find_checkpoint();
    run.go_on_from(checkpoint);
    const auto rows = read_lines(history);
    EXPECT_LT(rows.size(), n_rows);
    EXPECT_EQ(read_numbers(rows.back())[0], checkpoint.time);
  }



  TEST(Checkpoint, goes_on_beyond_the_former_end)
  {
    SmallSilo silo;
    observe_often(silo);
    silo.stage.end_time = 0.1;
    SmallRun(silo).run();
    silo.stage.end_time = 0.12;
    SmallRun run(silo);
    run.resume();
    EXPECT_NEAR(run.view().clock().time, 0.12, 1e-12);
    const auto rows = read_lines(silo.output.directory + "/history.csv");
    EXPECT_EQ(rows.size(), 1 + 13);
  }



  /// The checkpoint of a silo is refused after `change`, with a message that
  /// holds `reason`.
  template <typename Change>
  void
  expect_refusal_after(const Change &change, const std::string &reason)
  {
    SmallSilo silo;
    silo.stage.end_time             = 0.002;
    silo.output.checkpoint_interval = 1.;
    SmallRun(silo).run();
    silo.stage.end_time = 0.003;
    change(silo);
    std::string message;
    try
      {
        SmallRun(silo).resume();
      }
    catch (const InputError &error)
      {
        message = error.what();
      }
    EXPECT_NE(message.find(reason), std::string::npos) << message;
  }



  TEST(Checkpoint, refuses_another_material)
  {
    expect_refusal_after(
      [](SmallSilo &silo) { silo.set("Material", "Young modulus", "2e6"); },
      "Material/Young modulus = 1e+06, and now it is 2e6");
  }



  TEST(Checkpoint, refuses_another_method)
  {
    expect_refusal_after(
      [](SmallSilo &silo) {
        silo.set("Particle stage", "Split particles", "never");
      },
      "Particle stage/Split particles = where needed, and now it is never");
    expect_refusal_after(
      [](SmallSilo &silo) {
        silo.set("Particle stage", "Force integration", "particles");
      },
      "Particle stage/Force integration = cell, and now it is particles");
  }



  TEST(Checkpoint, refuses_an_end_that_is_not_later)
  {
    expect_refusal_after([](SmallSilo &silo) { silo.stage.end_time = 0.002; },
                         "parameter 'End time', value '0.002'");
    expect_refusal_after([](SmallSilo &silo) { silo.stage.end_time = 0.001; },
                         "checkpoint.bin', 0.002 s");
  }



  TEST(Checkpoint, takes_what_is_free_to_change)
  {
    SmallSilo silo;
    silo.stage.end_time             = 0.002;
    silo.output.checkpoint_interval = 1.;
    SmallRun(silo).run();
    silo.set("Particle stage", "End time", "0.004");
    silo.set("Particle stage", "Time step", "2e-4");
    silo.set("Particle stage", "Largest speed", "20");
    silo.set("Output", "History interval", "0.001");
    silo.set("Output", "Grid", "false");
    silo.set("Output", "Progress interval", "0");
    SmallRun run(silo);
    run.resume();
    EXPECT_NEAR(run.view().clock().time, 0.004, 1e-12);
  }



  TEST(Checkpoint, refuses_another_mesh)
  {
    expect_refusal_after(
      [](SmallSilo &silo) { silo.scene.element_size = 0.05; }, "Scene/mesh = ");
  }



  TEST(Checkpoint, refuses_a_broken_file)
  {
    expect_refusal_after(
      [](SmallSilo &silo) {
        std::filesystem::resize_file(
          CheckpointFiles(silo.output.directory).last, 5000);
      },
      "is damaged");
  }



  TEST(Checkpoint, refuses_a_directory_without)
  {
    expect_refusal_after(
      [](SmallSilo &silo) {
        std::filesystem::remove(CheckpointFiles(silo.output.directory).last);
      },
      "there is no '");
  }
} // namespace
