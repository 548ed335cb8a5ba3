#include <deal.II/base/mpi.h>

#include <sandglass/run/load_balance.h>

#include <gtest/gtest.h>

#include "empty_flow.h"

using namespace Sandglass;

namespace
{
  /// Does nothing but count steps, and costs the same in each.
  class FlowOfSteps : public EmptyFlow
  {
  public:
    FlowOfSteps(const unsigned int n_cells, const double work)
      : work(work)
      , n_cells(n_cells)
    {}

    void
    skip(const unsigned int n_steps)
    {
      time.step += n_steps;
    }

    std::vector<double>
    cell_work() const override
    {
      return std::vector<double>(n_cells, work);
    }

    double work; ///< of a cell

  private:
    const unsigned int n_cells;
  };
} // namespace



// The other ranks' waiting is added up until it is as long as moving takes;
// what the partition began with doesn't count.
TEST(LoadBalance, IsLostWhenRanksHaveWaitedForLong)
{
  const unsigned int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  const bool is_alone = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1;
  constexpr unsigned int n_cells = 1000;
  FlowOfSteps            flow(n_cells, 1. + 0.1 * rank);
  LoadBalance            balance;
  const auto             is_lost_within = [&](const unsigned int n_steps) {
    for (unsigned int n = 0; n < n_steps; n += 100)
      {
        flow.skip(100);
        if (balance.is_lost(flow, MPI_COMM_WORLD))
          return true;
      }
    return false;
  };
  EXPECT_FALSE(is_lost_within(400000));
  // All particles but one rank's are gone.
  if (rank > 0)
    flow.work = 0.;
  EXPECT_FALSE(is_lost_within(100));
  EXPECT_EQ(is_lost_within(400000), !is_alone);
  balance = {};
  EXPECT_FALSE(is_lost_within(400000));
}
