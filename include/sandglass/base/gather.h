#ifndef sandglass_base_gather_h
#define sandglass_base_gather_h

#include <deal.II/base/mpi.h>

#include <vector>

namespace Sandglass
{
  /// What all ranks have, in order of the ranks, on rank 0; empty on the
  /// others. Collective.
  template <typename T>
  std::vector<T>
  gather_on_first(const std::vector<T> &of_rank, const MPI_Comm communicator)
  {
    if (dealii::Utilities::MPI::n_mpi_processes(communicator) == 1)
      return of_rank;
    std::vector<T> all;
    for (const auto &part :
         dealii::Utilities::MPI::gather(communicator, of_rank))
      all.insert(all.end(), part.begin(), part.end());
    return all;
  }
} // namespace Sandglass

#endif
