#ifndef sandglass_tests_parallel_imbalance_h
#define sandglass_tests_parallel_imbalance_h

#include <deal.II/base/mpi.h>

#include <sandglass/scene/scene.h>

#include <vector>

/// The largest of the ranks' shares of the cells' weights over their mean.
inline double
imbalance(const Sandglass::Scene<2>       &scene,
          const std::vector<unsigned int> &weights)
{
  double own = 0.;
  for (const auto &cell : scene.triangulation.active_cell_iterators())
    if (cell->is_locally_owned())
      own += weights[cell->active_cell_index()];
  const auto shares =
    dealii::Utilities::MPI::min_max_avg(own, scene.communicator);
  return shares.max / shares.avg;
}

#endif
