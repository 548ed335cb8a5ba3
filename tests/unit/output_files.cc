// Boost 1.74 warns of its own use of boost/bind.hpp otherwise.
#define BOOST_BIND_GLOBAL_PLACEHOLDERS

#include <sandglass/base/exceptions.h>
#include <sandglass/output/csv_file.h>
#include <sandglass/output/json_object.h>
#include <sandglass/output/log.h>
#include <sandglass/output/progress.h>

#include <boost/archive/text_iarchive.hpp>
#include <boost/archive/text_oarchive.hpp>
#include <boost/property_tree/json_parser.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>

#include "output_silo.h"

using namespace Sandglass;

namespace
{
  /// A file that is gone after the test.
  struct TemporaryFile
  {
    TemporaryFile()
    {
      std::filesystem::remove(name);
    }
    ~TemporaryFile()
    {
      std::filesystem::remove(name);
    }
    const std::string name = SmallSilo::unique_path();
  };



  TEST(CsvFile, numbers_read_back_as_they_were)
  {
    for (const double number : {0.1, 1. / 3., 1e-300, -2.5e17, 0.})
      EXPECT_EQ(std::stod(to_text(number)), number);
    EXPECT_EQ(to_text(0.1), "0.1");
    EXPECT_EQ(to_text(std::numeric_limits<double>::quiet_NaN()), "nan");
  }



  TEST(CsvFile, rows)
  {
    const TemporaryFile file;
    CsvFile             table(file.name, {"time_s", "wall", "step"});
    table.open();
    table.add_row({0.5, std::string("floor"), 3ul});
    table.flush();
    EXPECT_EQ(read_text(file.name), "time_s,wall,step\n0.5,floor,3\n");
  }



  TEST(CsvFile, columns_of_a_table_where_they_are_there)
  {
    struct Row
    {
      double time;
      bool   has_step;
    };
    const std::vector<Column<Row>> columns = {
      {"time_s", "s", [](const Row &row) { return row.time; }, ""},
      {"step",
       "1",
       [](const Row &) { return 3ul; },
       "",
       [](const Row &row) { return row.has_step; }}};
    for (const bool has_step : {true, false})
      {
        const TemporaryFile file;
        const Row           row{0.5, has_step};
        CsvTable<Row>       table(file.name, columns, row);
        table.open();
        table.add_row(row);
        table.flush();
        EXPECT_EQ(read_text(file.name),
                  has_step ? "time_s,step\n0.5,3\n" : "time_s\n0.5\n");
      }
  }



  TEST(CsvFile, goes_on_behind_the_rows_of_its_archive)
  {
    const TemporaryFile file;
    std::stringstream   archive;
    {
      CsvFile table(file.name, {"a", "b"});
      table.open();
      table.add_row({1., 2.});
      boost::archive::text_oarchive(archive) << std::as_const(table);
      table.add_row({3., 4.});
      table.flush();
    }
    CsvFile table(file.name, {"a", "b"});
    boost::archive::text_iarchive(archive) >> table;
    table.open();
    table.add_row({5., 6.});
    table.flush();
    EXPECT_EQ(read_text(file.name), "a,b\n1,2\n5,6\n");
  }



  TEST(CsvFile, error_names_the_file)
  {
    CsvFile table("/no/such/directory/table.csv", {"a"});
    try
      {
        table.open();
        FAIL();
      }
    catch (const RunError &error)
      {
        EXPECT_NE(
          std::string(error.what()).find("/no/such/directory/table.csv"),
          std::string::npos);
      }
  }



  TEST(JsonObject, numbers_are_numbers)
  {
    JsonObject json;
    json.add("text", "a \"b\" \\ c\nd");
    json.add("count", 12ul);
    json.add("value", 0.1);
    json.add("none", std::nan(""));
    const std::string text = json.text();
    EXPECT_NE(text.find("\"count\": 12,"), std::string::npos);
    EXPECT_NE(text.find("\"value\": 0.1,"), std::string::npos);
    EXPECT_NE(text.find("\"none\": null"), std::string::npos);

    std::istringstream          stream(text);
    boost::property_tree::ptree tree;
    boost::property_tree::read_json(stream, tree);
    EXPECT_EQ(tree.get<std::string>("text"), "a \"b\" \\ c\nd");
  }



  TEST(Log, file_has_all_text_and_quiet_screen_none)
  {
    const TemporaryFile file;
    testing::internal::CaptureStdout();
    {
      Log log(MPI_COMM_SELF, Log::Screen::nothing);
      log.stream() << "before the file is open" << std::endl;
      log.open_file(file.name, false);
      log.stream() << "number " << 7 << '\n';
      log.show_progress("progress");
      log.record_error("error");
    }
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(read_text(file.name),
              "before the file is open\nnumber 7\nprogress\nerror\n");
    Log(MPI_COMM_SELF, Log::Screen::nothing).open_file(file.name, true);
    EXPECT_EQ(read_lines(file.name).size(), 4);
  }



  TEST(Log, screen_has_all_but_errors)
  {
    testing::internal::CaptureStdout();
    {
      Log log(MPI_COMM_SELF, Log::Screen::everything);
      log.stream() << "text" << std::endl;
      log.show_progress("progress");
      log.record_error("error");
    }
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "text\nprogress\n");
  }



  TEST(Log, screen_can_have_progress_only)
  {
    const TemporaryFile file;
    testing::internal::CaptureStdout();
    {
      Log log(MPI_COMM_SELF, Log::Screen::progress);
      log.open_file(file.name, false);
      log.stream() << "text" << std::endl;
      log.show_progress("progress");
    }
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "progress\n");
    EXPECT_EQ(read_text(file.name), "text\nprogress\n");
  }



  TEST(Progress, durations)
  {
    EXPECT_EQ(duration_to_text(0.4), "0:00:00");
    EXPECT_EQ(duration_to_text(59.6), "0:01:00");
    EXPECT_EQ(duration_to_text(36000. + 120. + 5.), "10:02:05");
  }
} // namespace
