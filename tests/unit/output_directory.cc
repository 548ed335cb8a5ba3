#include <sandglass/base/exceptions.h>
#include <sandglass/output/closing_lines.h>
#include <sandglass/output/output_directory.h>
#include <sandglass/output/own_files.h>
#include <sandglass/output/replace_file.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "output_silo.h"

using namespace Sandglass;

namespace
{
  TEST(OwnFiles, names)
  {
    for (const std::string name : {"history.csv",
                                   "particles.pvd",
                                   "vtu/particles_00000.vtu",
                                   "vtu/grid_00012.0003.vtu",
                                   "vtu/walls_100000.pvtu",
                                   "static.vtu"})
      EXPECT_EQ(own_file(name), OwnFile::result) << name;
    for (const std::string name : {"summary.json",
                                   "summary.json.3",
                                   "summary.json.3.new",
                                   "checkpoint.bin",
                                   "checkpoint-before.bin",
                                   "checkpoint-before.bin.new",
                                   "particles.pvd.new",
                                   "report.html",
                                   "study.svg"})
      EXPECT_EQ(own_file(name), OwnFile::leftover) << name;
    for (const std::string name : {"notes.txt",
                                   "my_history.csv",
                                   "history.csv.bak",
                                   "old/history.csv",
                                   "particles_00000.vtu",
                                   "vtu/particles.vtu",
                                   "silo.msh"})
      EXPECT_EQ(own_file(name), OwnFile::none) << name;
  }



  TEST(OutputDirectory, a_second_run_is_refused_until_the_first_ends)
  {
    const SmallSilo   silo;
    const std::string path = silo.output.directory;
    Log               log(MPI_COMM_SELF, Log::Screen::nothing);
    {
      OutputDirectory first(path, MPI_COMM_SELF);
      first.start(log);
      EXPECT_THROW(OutputDirectory(path, MPI_COMM_SELF), InputError);
    }
    EXPECT_NO_THROW(OutputDirectory(path, MPI_COMM_SELF));
  }



  TEST(OutputDirectory, of_two_that_have_found_none_one_is_refused)
  {
    const SmallSilo silo;
    Log             log(MPI_COMM_SELF, Log::Screen::nothing);
    OutputDirectory first(silo.output.directory, MPI_COMM_SELF),
      second(silo.output.directory, MPI_COMM_SELF);
    first.start(log);
    EXPECT_THROW(second.start(log), InputError);
  }



  TEST(SummaryFile, a_rank_that_fails_alone_says_so)
  {
    const SmallSilo   silo;
    const std::string path = silo.output.directory;
    std::filesystem::create_directories(path);
    amend_summary_file(path, Status::failed, "what", 1); // there is none
    EXPECT_TRUE(std::filesystem::is_empty(path));
    write_summary_file(path, "{\n  \"status\": \"running\",\n  \"n\": 3\n}\n");
    amend_summary_file(path, Status::failed, "no \"memory\"", 1);
    const std::string text =
      "{\n  \"status\": \"failed\",\n  \"message\": \"no \\\"memory\\\"\",\n"
      "  \"n\": 3\n}\n";
    EXPECT_EQ(read_text(summary_file(path)), text);
    // The first failure stays.
    amend_summary_file(path, Status::failed, "another", 2);
    EXPECT_EQ(read_text(summary_file(path)), text);
  }



  TEST(SummaryFile, is_written_over_where_there_is_no_room_for_a_second_one)
  {
    const SmallSilo   silo;
    const std::string path = silo.output.directory;
    std::filesystem::create_directories(path);
    write_summary_file(path, "a text that is longer than the next one");
    // So that no file of this name can be made.
    std::filesystem::create_directories(unfinished_name(summary_file(path)) +
                                        "/not-empty");
    write_summary_file(path, "a shorter text");
    EXPECT_EQ(read_text(summary_file(path)), "a shorter text");
    std::filesystem::remove(summary_file(path));
    EXPECT_THROW(write_summary_file(path, "text"), RunError);
  }



  TEST(SharedError, lack_of_memory_is_told_in_words)
  {
    const std::string message =
      shared_error(MPI_COMM_SELF, []() { throw std::bad_alloc(); });
    EXPECT_EQ(message.rfind("There is not enough memory. Try", 0), 0u);
  }



  TEST(ClosingLines, of_each_formulation)
  {
    Summary summary;
    summary.has_flow_rate       = true;
    summary.initial_mass        = 100.;
    summary.totals.mass_removed = 60.;
    summary.totals.mass_in_silo = 40.;
    summary.flow.plateau        = 12.345678;
    LargestPressure largest;
    largest.pressure         = 23456.;
    largest.wall             = "hopper";
    largest.x                = 0.25;
    largest.y                = 0.5;
    largest.time             = 1.5;
    largest.eurocode         = std::numeric_limits<double>::quiet_NaN();
    summary.largest_pressure = largest;
    EXPECT_EQ(closing_lines(summary, {{10., 9., 8.}}, "a/b"),
              "Discharged 60 of 100 kg/m; 40 still in the silo when the run "
              "ended\n"
              "Flow rate 12.35 kg/(s m) over the middle half of the discharge; "
              "Beverloo's is 10 with fine grains, 9 with grains of 0.1 outlet "
              "widths\n"
              "Largest wall pressure 23.46 kPa on 'hopper' at x = 0.25 m, y = "
              "0.5 m, t = 1.5 s\n"
              "Results are in a/b; a page with all of them: sandglass-report "
              "a/b\n");

    summary.formulation                = Formulation::axisymmetric;
    summary.flow.discharge_time        = 4.;
    summary.largest_pressure->eurocode = 21000.;
    const std::string text = closing_lines(summary, {{10., 9., 8.}}, "a");
    EXPECT_NE(text.find("Discharged 60 of 100 kg; 40 stays in the silo\n"),
              std::string::npos)
      << text;
    EXPECT_NE(text.find("Flow rate 12.35 kg/s over"), std::string::npos);
    EXPECT_NE(text.find("1.5 s; EN 1991-4 has 21 kPa there at discharge\n"),
              std::string::npos);

    // A silo without an outlet, and without tables of its walls.
    EXPECT_EQ(closing_lines(Summary(), {}, "a").rfind("Results are in a", 0),
              0u);
  }
} // namespace
