#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <iostream>

namespace
{
  /// On the ranks other than 0: print failures only.
  class FailurePrinter : public testing::EmptyTestEventListener
  {
  public:
    explicit FailurePrinter(const unsigned int rank)
      : rank(rank)
    {}

    void
    OnTestPartResult(const testing::TestPartResult &result) override
    {
      if (result.failed())
        std::cout << "rank " << rank << ": " << result.file_name() << ':'
                  << result.line_number() << ": " << result.message()
                  << std::endl;
    }

  private:
    const unsigned int rank;
  };
} // namespace

int
main(int argc, char **argv)
{
  testing::InitGoogleTest(&argc, argv);

  // ctest asks for the tests' names; that needs no MPI.
  if (GTEST_FLAG_GET(list_tests))
    return RUN_ALL_TESTS();

  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const unsigned int                       rank =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);

  if (rank != 0)
    {
      testing::TestEventListeners &listeners =
        testing::UnitTest::GetInstance()->listeners();
      delete listeners.Release(listeners.default_result_printer());
      listeners.Append(new FailurePrinter(rank));
    }

  // An Assert of deal.II that fails (Debug) fails its test, not the program.
  dealii::deal_II_exceptions::disable_abort_on_exception();

  std::cout.precision(10);

  // A failure on any rank is a failure on all.
  return dealii::Utilities::MPI::max(RUN_ALL_TESTS(), MPI_COMM_WORLD);
}
