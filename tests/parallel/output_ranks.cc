#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPUnstructuredGridReader.h>

#include <cmath>
#include <filesystem>

#include "output_silo.h"

using namespace Sandglass;

namespace
{
  void
  make_short(SmallSilo &silo)
  {
    silo.stage.end_time             = 0.12;
    silo.output.interval            = 0.05;
    silo.output.checkpoint_interval = 0.06;
    silo.output.gauges = {{"wall", {0.4, 0.35}}, {"middle", {0.1, 0.3}}};
  }



  /// Whether two tables agree but for rounding. Empty fields don't occur.
  void
  expect_same_table(const std::string &a, const std::string &b)
  {
    const auto lines_a = read_lines(a), lines_b = read_lines(b);
    ASSERT_EQ(lines_a.size(), lines_b.size()) << a;
    EXPECT_EQ(lines_a[0], lines_b[0]);
    std::vector<double> scale(read_numbers(lines_a[0]).size(), 1e-9);
    for (const auto &line : lines_a)
      for (unsigned int i = 0; i < scale.size(); ++i)
        scale[i] = std::fmax(scale[i], std::abs(read_numbers(line)[i]));
    for (unsigned int row = 1; row < lines_a.size(); ++row)
      for (unsigned int i = 0; i < scale.size(); ++i)
        {
          const double value_a = read_numbers(lines_a[row])[i];
          const double value_b = read_numbers(lines_b[row])[i];
          EXPECT_TRUE(std::abs(value_a - value_b) <= 1e-9 * scale[i] ||
                      (std::isnan(value_a) && std::isnan(value_b)))
            << a << ", row " << row << ", column " << i << ": " << value_a
            << ' ' << value_b;
        }
  }



  /// Compare the tables in two output directories on rank 0.
  void
  expect_same_tables(const SmallSilo &a, const SmallSilo &b)
  {
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      for (const std::string name : {"/history.csv",
                                     "/flow_rate.csv",
                                     "/wall_traction.csv",
                                     "/wall_envelope.csv",
                                     "/flow_profile.csv",
                                     "/residence.csv",
                                     "/gauges.csv"})
        expect_same_table(a.output.directory + name, b.output.directory + name);
  }



  TEST(OutputOnRanks, same_tables_as_on_one)
  {
    SmallSilo alone(MPI_COMM_SELF, "_alone"), together(MPI_COMM_WORLD);
    make_short(alone);
    make_short(together);
    SmallRun(alone).run();
    SmallRun(together).run();
    expect_same_tables(alone, together);
  }



  TEST(OutputOnRanks, pieces_make_a_whole)
  {
    SmallSilo silo(MPI_COMM_WORLD);
    silo.stage.end_time = 0.;
    SmallRun(silo).run();
    const std::string filename =
      silo.output.directory + "/vtu/particles_00000.pvtu";
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0 &&
        Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
      {
        vtkNew<vtkXMLPUnstructuredGridReader> reader;
        reader->SetFileName(filename.c_str());
        reader->Update();
        auto  *fields = reader->GetOutput()->GetPointData();
        double mass   = 0.;
        for (int i = 0; i < reader->GetOutput()->GetNumberOfPoints(); ++i)
          mass += fields->GetArray("mass")->GetTuple1(i);
        EXPECT_NEAR(mass, 480., 1e-9);
        EXPECT_STREQ(fields->GetArray("stress")->GetComponentName(3), "XY");
        EXPECT_EQ(fields->GetArray("layer")->GetRange()[1], 16.);
      }
  }



  TEST(OutputOnRanks, resumed_run_is_the_same_bit_by_bit)
  {
    SmallSilo whole(MPI_COMM_WORLD), parts(MPI_COMM_WORLD, "_parts");
    make_short(whole);
    make_short(parts);
    SmallRun(whole).run();
    SmallRun(parts).run(0.1);
    SmallRun(parts).resume();
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return;
    for (const std::string name :
         {"/history.csv", "/flow_rate.csv", "/wall_traction.csv"})
      EXPECT_EQ(read_text(whole.output.directory + name),
                read_text(parts.output.directory + name));
  }



  /// Put all results of one run in the place of those of another.
  void
  copy_results(const SmallSilo &from, const SmallSilo &to)
  {
    std::filesystem::remove_all(to.output.directory);
    std::filesystem::copy(from.output.directory,
                          to.output.directory,
                          std::filesystem::copy_options::recursive);
  }



  TEST(OutputOnRanks, checkpoint_of_one_goes_on_on_several)
  {
    SmallSilo alone(MPI_COMM_SELF, "_alone"), together(MPI_COMM_WORLD);
    make_short(alone);
    make_short(together);
    SmallRun(alone).run(0.1);
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      copy_results(alone, together);
    MPI_Barrier(MPI_COMM_WORLD);
    SmallRun(together).resume();
    SmallRun(alone).resume();
    expect_same_tables(alone, together);
  }



  TEST(OutputOnRanks, checkpoint_of_several_goes_on_on_one)
  {
    SmallSilo alone(MPI_COMM_SELF, "_alone"), together(MPI_COMM_WORLD);
    make_short(alone);
    make_short(together);
    SmallRun(together).run(0.1);
    MPI_Barrier(MPI_COMM_WORLD);
    copy_results(together, alone);
    MPI_Barrier(MPI_COMM_WORLD);
    SmallRun(together).resume();
    SmallRun(alone).resume();
    expect_same_tables(alone, together);
  }
} // namespace
