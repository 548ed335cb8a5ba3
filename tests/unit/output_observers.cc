// Boost 1.74 warns of its own use of boost/bind.hpp otherwise.
#define BOOST_BIND_GLOBAL_PLACEHOLDERS

#include <sandglass/base/exceptions.h>
#include <sandglass/output/output_directory.h>

#include <boost/property_tree/json_parser.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "output_silo.h"

using namespace Sandglass;

namespace
{
  const std::string history_header =
    "time_s,step,time_step_s,time_step_over_critical,kinetic_energy_J,"
    "elastic_energy_J,dissipated_energy_J,momentum_x_kg_m_per_s,"
    "momentum_y_kg_m_per_s,mass_in_silo_kg,mass_falling_kg,mass_discharged_kg,"
    "mass_lost_kg,largest_speed_m_per_s,slipping_wall_share,stagnant_mass_kg";

  const std::string flow_rate_header =
    "time_s,discharged_mass_kg,mass_flow_rate_kg_per_s,beverloo_0_kg_per_s,"
    "beverloo_0.1_kg_per_s,beverloo_0.2_kg_per_s";

  const std::string wall_traction_header =
    "time_s,wall,arc_length_m,x_m,y_m,normal_Pa,tangential_Pa,"
    "janssen_normal_Pa,side,en_1991_4_filling_normal_Pa,"
    "en_1991_4_filling_tangential_Pa,en_1991_4_discharge_normal_Pa,"
    "en_1991_4_discharge_tangential_Pa";

  boost::property_tree::ptree
  read_json(const std::string &filename)
  {
    boost::property_tree::ptree tree;
    boost::property_tree::read_json(filename, tree);
    return tree;
  }



  TEST(Observers, tables_of_a_discharge)
  {
    SmallSilo silo;
    silo.stage.end_time = 0.3;
    SmallRun          run(silo);
    const std::string directory = silo.output.directory + '/';
    run.run();

    const auto history = read_lines(directory + "history.csv");
    ASSERT_EQ(history.size(), 1 + 31);
    EXPECT_EQ(history[0], history_header);
    constexpr double mass = 1500. * 0.8 * 0.8; // of both halves
    for (unsigned int i = 1; i < history.size(); ++i)
      {
        const auto row = read_numbers(history[i]);
        EXPECT_NEAR(row[0], 0.01 * (i - 1), 1e-9);
        EXPECT_EQ(row[1], 20. * (i - 1));
        EXPECT_NEAR(row[9] + row[11] + row[12], mass, 1e-12 * mass);
        EXPECT_LE(row[10], row[11]);
      }
    const auto last = read_numbers(history.back());
    EXPECT_GT(last[3], 0.); // time step over critical
    EXPECT_LT(last[3], 1.);
    EXPECT_GT(last[4], 0.);                                // kinetic energy
    EXPECT_LT(last[8], 0.);                                // falls
    EXPECT_GT(last[11], last[10]);                         // some is removed
    EXPECT_TRUE(std::isnan(read_numbers(history[1])[14])); // no step yet
    EXPECT_GT(last[14], 0.); // share of the walls that slips
    EXPECT_LE(last[14], 1.);
    EXPECT_NEAR(read_numbers(history[1])[15], mass, 1e-9); // all is at rest
    EXPECT_GT(last[15], 0.);
    EXPECT_LT(last[15], last[9]);

    const auto flow_rate = read_lines(directory + "flow_rate.csv");
    ASSERT_EQ(flow_rate.size(), 1 + 31);
    EXPECT_EQ(flow_rate[0], flow_rate_header);
    const auto last_rate  = read_numbers(flow_rate.back());
    const auto window_ago = read_numbers(flow_rate[flow_rate.size() - 11]);
    EXPECT_EQ(last_rate[1], last[11]);
    EXPECT_NEAR(last_rate[2], (last_rate[1] - window_ago[1]) / 0.1, 1e-6);
    // 45/60 sqrt(2 g) rho D^(3/2)
    EXPECT_NEAR(last_rate[3],
                0.75 * std::sqrt(2. * 9.81) * 1500. * std::pow(0.4, 1.5),
                1e-9);

    const auto walls = read_lines(directory + "wall_traction.csv");
    EXPECT_EQ(walls[0], wall_traction_header);
    EXPECT_EQ(walls.size(), 1 + 3 * 12);
  }



  TEST(Observers, summary)
  {
    SmallSilo silo;
    silo.stage.end_time = 0.3;
    SmallRun run(silo);
    run.run();

    const auto summary = read_json(silo.output.directory + "/summary.json");
    for (const std::string key : {"version",
                                  "ranks",
                                  "particles",
                                  "cells",
                                  "steps",
                                  "particle_steps",
                                  "setup_seconds",
                                  "static_seconds",
                                  "loop_seconds",
                                  "output_seconds",
                                  "particle_steps_per_second",
                                  "peak_rss_MiB",
                                  "mass_initial_kg",
                                  "mass_in_silo_kg",
                                  "mass_discharged_kg",
                                  "mass_lost_kg",
                                  "mass_balance_error",
                                  "flow_rate_plateau_kg_per_s",
                                  "steady_flow_start_s",
                                  "steady_flow_end_s",
                                  "steady_flow_rate_kg_per_s",
                                  "discharge_time_s",
                                  "residual_mass_kg",
                                  "stagnant_mass_kg",
                                  "slipping_wall_share",
                                  "end_time_s"})
      EXPECT_EQ(summary.count(key), 1) << key;
    EXPECT_EQ(summary.get<std::string>("status"), "finished");
    EXPECT_EQ(summary.get<unsigned int>("steps"), 600);
    EXPECT_LT(summary.get<double>("mass_balance_error"), 1e-12);
    EXPECT_NEAR(summary.get<double>("mass_initial_kg"), 960., 1e-9);
    EXPECT_GT(summary.get<double>("flow_rate_plateau_kg_per_s"), 0.);
    EXPECT_GT(summary.get<double>("loop_seconds"), 0.);
    EXPECT_GT(summary.get<double>("peak_rss_MiB"), 1.);
  }



  TEST(Observers, stagnant_mass_is_left_out_where_nobody_asks)
  {
    SmallSilo silo;
    silo.output.stagnant_displacement = 0.;
    silo.stage.end_time               = 0.02;
    SmallRun run(silo);
    run.run();
    const std::string directory = silo.output.directory + '/';
    EXPECT_EQ(read_text(directory + "history.csv").find("stagnant"),
              std::string::npos);
    EXPECT_EQ(read_json(directory + "summary.json").count("stagnant_mass_kg"),
              0);
  }



  TEST(Observers, static_state_gives_tractions_and_effort_at_the_start)
  {
    SmallSilo silo;
    silo.stage.end_time = 0.;
    SmallRun run(silo);
    AtRest   at_rest{run.view().wall_records(), {90, false, 7, 30}};
    at_rest.wall_records.time = 1.;
    for (auto &record : at_rest.wall_records.records)
      record.impulse = -500. * record.area * record.normal;
    run.run(1e300, &at_rest);

    const auto summary = read_json(silo.output.directory + "/summary.json");
    EXPECT_EQ(summary.get<unsigned int>("static_unknowns"), 90);
    EXPECT_EQ(summary.get<std::string>("static_solver"), "multigrid");
    EXPECT_EQ(summary.get<unsigned int>("static_newton_iterations"), 7);
    EXPECT_EQ(summary.get<unsigned int>("static_linear_iterations"), 30);

    const auto walls = read_lines(silo.output.directory + "/wall_traction.csv");
    ASSERT_EQ(walls.size(), 1 + 12);
    EXPECT_EQ(walls[1].substr(0, 9), "0,wall,0,");
    EXPECT_NEAR(read_numbers(walls[1])[5], 500., 1e-9);
    EXPECT_NE(read_text(silo.output.directory + "/walls.pvd").find("timestep"),
              std::string::npos);
  }



  TEST(Observers, closed_silo_has_no_flow_rate)
  {
    SmallSilo silo;
    silo.scene.outlet_is_open = false;
    silo.stage.end_time       = 0.02;
    SmallRun run(silo);
    run.run();
    EXPECT_FALSE(
      std::filesystem::exists(silo.output.directory + "/flow_rate.csv"));
    const auto summary = read_json(silo.output.directory + "/summary.json");
    EXPECT_EQ(summary.count("flow_rate_plateau_kg_per_s"), 0);
  }



  TEST(Observers, what_is_switched_off_leaves_no_file)
  {
    SmallSilo silo;
    silo.stage.end_time          = 0.02;
    silo.output.writes_particles = false;
    silo.output.writes_grid      = false;
    silo.output.writes_walls     = false;
    SmallRun run(silo);
    run.run();
    for (const std::string name :
         {"particles.pvd", "grid.pvd", "walls.pvd", "wall_traction.csv"})
      EXPECT_FALSE(std::filesystem::exists(silo.output.directory + '/' + name))
        << name;
    EXPECT_FALSE(std::filesystem::exists(silo.output.directory + "/vtu"));
    for (const std::string name :
         {"history.csv", "flow_rate.csv", "sandglass.log"})
      EXPECT_TRUE(std::filesystem::exists(silo.output.directory + '/' + name))
        << name;
  }



  TEST(Observers, failure_keeps_results)
  {
    SmallSilo silo;
    SmallRun  run(silo);
    OutputDirectory(silo.output.directory, MPI_COMM_SELF).start(run.log);
    run.observers.start(run.view(), nullptr);
    run.observers.finish_after_failure("Step 7: a particle \"flew\" away");

    const auto summary = read_json(silo.output.directory + "/summary.json");
    EXPECT_EQ(summary.get<std::string>("status"), "failed");
    EXPECT_EQ(summary.get<std::string>("message"),
              "Step 7: a particle \"flew\" away");
    EXPECT_EQ(read_lines(silo.output.directory + "/history.csv").size(), 2);
    EXPECT_EQ(read_lines(silo.output.directory + "/sandglass.log").back(),
              "Step 7: a particle \"flew\" away");
  }



  TEST(OutputDirectory, unwritable_is_refused)
  {
    SmallSilo silo;
    silo.output.directory = "/dev/null/results";
    Log log(MPI_COMM_SELF, Log::Screen::nothing);
    try
      {
        OutputDirectory(silo.output.directory, MPI_COMM_SELF).start(log);
        FAIL();
      }
    catch (const InputError &error)
      {
        EXPECT_EQ(error.name, "Directory");
      }
  }
} // namespace
