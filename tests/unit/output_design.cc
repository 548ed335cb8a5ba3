// Boost 1.74 warns of its own use of boost/bind.hpp otherwise.
#define BOOST_BIND_GLOBAL_PLACEHOLDERS

#include <sandglass/base/exceptions.h>
#include <sandglass/output/design_results.h>

#include <boost/property_tree/json_parser.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

#include "output_silo.h"

using namespace Sandglass;

namespace
{
  const double nothing = std::nan("");

  FlowLevel
  level(const std::string &side, const double y, const double wall_speed)
  {
    return {y, y + 0.5, side, wall_speed, 1.};
  }

  /// A wall that bears this pressure.
  WallTraction
  traction(const double time, const double pressure)
  {
    WallTraction result{};
    result.time          = time;
    result.role          = BoundaryRole::wall;
    result.wall_name     = "wall";
    result.record.normal = Tensor<1, 3>({1., 0., 0.});
    // The wall pushes to the left and upwards.
    result.on_material = Tensor<1, 3>({-pressure, 0.3 * pressure, 0.});
    return result;
  }

  ParticleRecord
  particle(const Point<3> &first_place, const double y, const double mass)
  {
    ParticleRecord record{};
    record.initial_location = first_place;
    record.location         = Point<3>(0.1, y, 0.);
    record.mass             = mass;
    record.density          = 1500.;
    return record;
  }

  /// Rows of a table with texts in it, by column.
  std::vector<std::map<std::string, std::string>>
  read_rows(const std::string &filename)
  {
    std::vector<std::map<std::string, std::string>> rows;
    const auto lines = read_lines(filename);
    const auto split = [](const std::string &line) {
      std::vector<std::string> words;
      std::istringstream       stream(line);
      for (std::string word; std::getline(stream, word, ',');)
        words.push_back(word);
      return words;
    };
    const auto names = split(lines.at(0));
    for (unsigned int i = 1; i < lines.size(); ++i)
      {
        const auto words = split(lines[i]);
        rows.emplace_back();
        for (unsigned int j = 0; j < names.size(); ++j)
          rows.back()[names[j]] = words.at(j);
      }
    return rows;
  }

  double
  sum(const std::vector<std::map<std::string, std::string>> &rows,
      const std::string                                     &column,
      const std::string                                     &time = "")
  {
    double result = 0.;
    for (const auto &row : rows)
      if (time.empty() || row.at("time_s") == time)
        result += std::stod(row.at(column));
    return result;
  }
} // namespace



TEST(FlowKind, MassFlow)
{
  const FlowKind kind({level("right", 0., 0.35), level("right", 1., 0.9)});
  EXPECT_EQ(kind.name, "mass flow");
  EXPECT_TRUE(std::isnan(kind.transition));
  EXPECT_EQ(kind.smallest_mass_flow_index, 0.35);
}



TEST(FlowKind, MixedFlowHasItsTransitionAtTheHighestStandingLevel)
{
  const FlowKind kind({level("left", 0., 0.),
                       level("left", 1., 0.1),
                       level("left", 2., 0.8),
                       level("right", 0., 0.),
                       level("right", 1., 0.8),
                       // No material.
                       level("right", 2., nothing)});
  EXPECT_EQ(kind.name, "mixed flow");
  EXPECT_EQ(kind.transition, 1.5);
  EXPECT_EQ(kind.smallest_mass_flow_index, 0.);
}



TEST(FlowKind, PipeFlowStandsUpToTheSurface)
{
  const FlowKind kind({level("right", 0., 0.), level("right", 1., 0.29)});
  EXPECT_EQ(kind.name, "pipe flow");
  EXPECT_EQ(kind.transition, 1.5);
}



TEST(FlowKind, WithoutFlowThereIsNone)
{
  const FlowKind kind({{0., 1., "right", 0., 0.}});
  EXPECT_EQ(kind.name, "");
  EXPECT_TRUE(std::isnan(kind.smallest_mass_flow_index));
}



TEST(WallEnvelope, LargestAndSmallestWithTheirTimes)
{
  WallEnvelope envelope;
  const auto   add =
    [&envelope](const double time, const double pressure, const double mass) {
      std::vector<WallTraction> tractions{traction(time, pressure)};
      envelope.add(tractions, mass);
      return tractions[0].range;
    };
  EXPECT_TRUE(std::isnan(add(0., 100., 1.).largest));
  add(0.1, 90., 0.9);
  add(0.2, 140., 0.8);
  add(0.3, 80., 0.75);
  // The silo runs empty.
  const NormalRange range = add(0.4, 10., 0.74);
  EXPECT_EQ(range.filling, 100.);
  EXPECT_EQ(range.filling_tangential, 30.);
  EXPECT_EQ(range.largest, 140.);
  EXPECT_EQ(range.largest_time, 0.2);
  EXPECT_EQ(range.largest_tangential, 42.);
  EXPECT_EQ(range.ratio(), 1.4);
  EXPECT_EQ(range.smallest, 80.);
  EXPECT_EQ(range.smallest_time, 0.3);
}



TEST(WallEnvelope, AnOutletThatOpensHasNoRow)
{
  std::vector<WallTraction> tractions{traction(0., 1.), traction(0., 2.)};
  tractions[1].role  = BoundaryRole::outlet;
  const auto n_lines = [&tractions](const bool opens) {
    const std::string text = wall_envelope_text(tractions, opens);
    return std::count(text.begin(), text.end(), '\n');
  };
  EXPECT_EQ(n_lines(true), 2);
  EXPECT_EQ(n_lines(false), 3);
}



// Two places one above the other, of 2 kg and 4 kg. The first is split in
// halves, of which one leaves between t = 1 and 2 s and the other between 2 and
// 4 s; the second stays, or leaves first.
TEST(Residence, TimesByFirstPlace)
{
  SmallSilo      silo;
  SmallRun       run(silo);
  const Point<3> low(0.2, 0.405, 0.), high(0.2, 0.415, 0.);
  for (const bool is_upper_first : {false, true})
    {
      Residence  residence(silo.output, run.scene);
      const auto pass = [&residence, low, high](const double time,
                                                const double y_1,
                                                const double y_2,
                                                const double y_high) {
        residence.add(particle(low, y_1, 1.));
        residence.add(particle(low, y_2, 1.));
        residence.add(particle(high, y_high, 4.));
        residence.end_pass(time);
      };
      pass(0., 0.4, 0.4, 0.4);
      residence.rows(0.);
      pass(1., 0.1, 0.1, is_upper_first ? -0.1 : 0.2);
      pass(2., -0.1, 0.1, is_upper_first ? -0.1 : 0.2);
      pass(4., -0.1, -0.1, is_upper_first ? -0.1 : 0.2);

      // Whole silo: twice the half.
      double left = 0., remaining = 0.;
      for (const ResidenceRow &row : residence.rows(4.))
        {
          left += row.mass_left;
          remaining += row.mass_remaining;
        }
      EXPECT_EQ(left, is_upper_first ? 12. : 4.);
      EXPECT_EQ(remaining, is_upper_first ? 0. : 8.);
      // The lower place: (1.5 + 3) / 2 and half their difference; the upper
      // one: 0.5 s.
      const ResidenceSummary summary = residence.summary();
      EXPECT_EQ(summary.mean_time,
                is_upper_first ? (2. * 2.25 + 4. * 0.5) / 6. : 2.25);
      if (!is_upper_first)
        {
          EXPECT_EQ(summary.spread, 0.75);
        }
      EXPECT_EQ(summary.in_order_share, is_upper_first ? 0. : 1.);
    }
}



TEST(Residence, MassesAreThoseOfTheRun)
{
  SmallSilo silo;
  silo.stage.end_time  = 0.35;
  silo.output.interval = 0.05;
  SmallRun          run(silo);
  const std::string directory = silo.output.directory + '/';
  run.run();

  const auto history =
    read_numbers(read_lines(directory + "history.csv").back());
  const double in_silo = history[9], discharged = history[11];
  ASSERT_GT(discharged, 50.);
  const auto rows = read_rows(directory + "residence.csv");
  ASSERT_EQ(rows.size() % 16, 0);
  EXPECT_NEAR(sum(rows, "mass_left_kg"), discharged, 1e-12 * in_silo);
  EXPECT_NEAR(sum(rows, "mass_remaining_kg", rows.back().at("time_s")),
              in_silo,
              1e-12 * in_silo);
  // The lowest layer leaves, and the highest one not yet.
  std::map<std::string, double> left;
  for (const auto &row : rows)
    left[row.at("layer")] += std::stod(row.at("mass_left_kg"));
  EXPECT_GT(left.at("16"), 10.);
  EXPECT_EQ(left.at("1"), 0.);
  EXPECT_TRUE(std::filesystem::exists(directory + "residence.vtu"));
}



TEST(Gauges, TractionsAreThoseOfTheWall)
{
  SmallSilo silo;
  silo.stage.end_time          = 0.1;
  silo.output.interval         = 0.02;
  silo.output.history_interval = 0.02;
  // On a node, between two, and in the material.
  SmallSilo::set("Output",
                 "Gauges",
                 "between: 0.4 0.35, middle: 0.2 0.4, node: 0.4 0.3");
  SmallRun          run(silo);
  const std::string directory = silo.output.directory + '/';
  run.run();

  const auto gauges = read_rows(directory + "gauges.csv");
  const auto walls  = read_rows(directory + "wall_traction.csv");
  ASSERT_EQ(gauges.size(), 3 * 6);
  const auto of_wall = [&walls](const std::string &time, const double y) {
    for (const auto &row : walls)
      if (row.at("time_s") == time && row.at("wall") == "wall" &&
          std::abs(std::stod(row.at("y_m")) - y) < 1e-6)
        return std::stod(row.at("normal_Pa"));
    return nothing;
  };
  double largest = 0.;
  for (const auto &row : gauges)
    {
      const double normal = std::stod(row.at("normal_Pa"));
      if (row.at("gauge") == "middle" || row.at("time_s") == "0")
        EXPECT_TRUE(std::isnan(normal)); // no wall; no state at rest
      else if (row.at("gauge") == "node")
        EXPECT_NEAR(normal, of_wall(row.at("time_s"), 0.3), 1e-6);
      else
        EXPECT_NEAR(normal,
                    (of_wall(row.at("time_s"), 0.3) +
                     of_wall(row.at("time_s"), 0.4)) /
                      2.,
                    1e-3 * std::abs(normal));
      if (!std::isnan(normal))
        largest = std::max(largest, normal);
    }
  EXPECT_GT(largest, 100.);
}



// Without a state at rest all material is unstressed at first.
TEST(Gauges, StateOfTheMaterialAround)
{
  SmallSilo silo;
  silo.stage.end_time = 0.;
  SmallSilo::set("Output", "Gauges", "a: 0.2 0.4, outside of it: 0.1 -0.05");
  SmallRun run(silo);
  run.run();
  const auto rows = read_rows(silo.output.directory + "/gauges.csv");
  ASSERT_EQ(rows.size(), 2);
  EXPECT_NEAR(std::stod(rows[0].at("density_kg_per_m3")), 1500., 1e-9);
  EXPECT_EQ(std::stod(rows[0].at("velocity_y_m_per_s")), 0.);
  EXPECT_EQ(std::stod(rows[0].at("stress_yy_Pa")), 0.);
  EXPECT_TRUE(std::isnan(std::stod(rows[1].at("density_kg_per_m3"))));
}



TEST(Gauges, PointsOutsideAreRefused)
{
  SmallSilo silo;
  for (const std::string value : {"a: 0.5 0.4", "a: 0.2 -0.2", "a: 0.2 0.4 0"})
    {
      SmallSilo::set("Output", "Gauges", value);
      EXPECT_THROW(SmallRun run(silo), InputError) << value;
    }
}
