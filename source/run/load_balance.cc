#include <deal.II/base/mpi.h>

#include <sandglass/run/load_balance.h>
#include <sandglass/scene/partition.h>

#include <algorithm>
#include <numeric>

namespace Sandglass
{
  bool
  LoadBalance::is_lost(const Flow &flow, const MPI_Comm communicator)
  {
    constexpr unsigned long interval = 100;
    // Triangulation, degrees of freedom and a new flow: about 2 us per cell,
    // where a particle takes 20 ns.
    constexpr double cost_of_cell = 100.;

    if (Utilities::MPI::n_mpi_processes(communicator) == 1 ||
        flow.view().clock().step % interval != 0)
      return false;

    const std::vector<double> cells = flow.cell_work();
    const auto                work  = Utilities::MPI::min_max_avg(
      std::accumulate(cells.begin(), cells.end(), 0.), communicator);
    const double more = work.max - work.avg;
    if (wait_at_start < 0.)
      wait_at_start = more;
    wait += interval * std::max(0., more - wait_at_start);
    return wait > cost_of_cell * cells.size();
  }



  std::vector<unsigned int>
  cell_weights(const Flow &flow, const MPI_Comm communicator)
  {
    std::vector<double> work = flow.cell_work();
    Utilities::MPI::sum(work, communicator, work);
    return cell_weights(work);
  }
} // namespace Sandglass
