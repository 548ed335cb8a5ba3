#include <deal.II/base/mpi.h>

#include <deal.II/distributed/shared_tria.h>
#include <deal.II/distributed/tria.h>

#include <sandglass/choices/dimensions.h>
#include <sandglass/scene/partition.h>
#include <sandglass/scene/triangulate.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace Sandglass
{
  namespace
  {
    /// A cell without particles is looked at in each loop over cells.
    constexpr unsigned int weight_of_cell = 1, weight_of_particle = 20;



    /// METIS adds them up in 32 bits.
    std::vector<unsigned int>
    for_metis(std::vector<unsigned int> weights)
    {
      constexpr std::uint64_t largest_sum = 1u << 30;
      const std::uint64_t     sum =
        std::accumulate(weights.begin(), weights.end(), std::uint64_t(0));
      const unsigned int divisor = 1 + sum / largest_sum;
      for (unsigned int &weight : weights)
        weight = std::max(1u, weight / divisor);
      return weights;
    }



    /// Call `distribute()`, which shares the cells out, with these weights.
    template <int dim, typename Distribute>
    void
    distribute_by_weight(Triangulation<dim>              &triangulation,
                         const std::vector<unsigned int> &weights,
                         const Distribute                &distribute)
    {
      const auto connection = triangulation.signals.weight.connect(
        [&weights](const auto &cell, auto) {
          return weights[cell->active_cell_index()];
        });
      distribute();
      connection.disconnect();
    }



    template <int dim>
    std::unique_ptr<parallel::TriangulationBase<dim>>
    partition_by_metis(const Mesh<dim>                 &mesh,
                       const std::vector<unsigned int> &weights,
                       const MPI_Comm                   communicator)
    {
      using Shared       = parallel::shared::Triangulation<dim>;
      auto triangulation = std::make_unique<Shared>(communicator,
                                                    Triangulation<dim>::none,
                                                    true,
                                                    Shared::partition_metis);
      distribute_by_weight(*triangulation, for_metis(weights), [&]() {
        triangulate(mesh, *triangulation);
      });
      return triangulation;
    }



    /// Its coarse cells are the mesh's, which every rank holds.
    template <int dim>
    std::unique_ptr<parallel::TriangulationBase<dim>>
    partition_by_p4est(const Mesh<dim>                 &mesh,
                       const std::vector<unsigned int> &weights,
                       const MPI_Comm                   communicator)
    {
      using Distributed  = parallel::distributed::Triangulation<dim>;
      auto triangulation = std::make_unique<Distributed>(communicator);
      triangulate(mesh, *triangulation);
      distribute_by_weight(*triangulation, weights, [&]() {
        triangulation->repartition();
      });
      return triangulation;
    }
  } // namespace



  double
  cell_work(const unsigned int n_particles, const double n_leaving)
  {
    // The cell's own work, such as its sums at the nodes; and what it takes to
    // find a particle's new cell and to store it there. Both are measured, see
    // doc/performance.md.
    constexpr double work_of_cell = 2., work_of_change = 7.;
    return n_particles == 0 ?
             0. :
             n_particles + work_of_cell + work_of_change * n_leaving;
  }



  std::vector<unsigned int>
  cell_weights(const std::vector<double> &work)
  {
    std::vector<unsigned int> weights;
    for (const double work_of_cell : work)
      weights.push_back(weight_of_cell +
                        std::lround(weight_of_particle * work_of_cell));
    return weights;
  }



  template <int dim>
  std::vector<unsigned int>
  cell_weights(const Mesh<dim> &mesh, const unsigned int particles_per_cell)
  {
    std::vector<double> work;
    for (const auto &cell : mesh.cells)
      work.push_back(cell_work(cell.is_filled ? particles_per_cell : 0));
    return cell_weights(work);
  }



  template <int dim>
  std::unique_ptr<parallel::TriangulationBase<dim>>
  partition(const Mesh<dim>                 &mesh,
            const std::vector<unsigned int> &weights,
            const Partitioner                partitioner,
            const MPI_Comm                   communicator)
  {
    return partitioner == Partitioner::metis ?
             partition_by_metis(mesh, weights, communicator) :
             partition_by_p4est(mesh, weights, communicator);
  }



  template <int dim>
  std::vector<types::subdomain_id>
  find_cell_owners(const parallel::TriangulationBase<dim> &triangulation)
  {
    std::vector<types::subdomain_id> owners(triangulation.n_active_cells(), 0);
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        owners[cell->active_cell_index()] =
          triangulation.locally_owned_subdomain();
    Utilities::MPI::max(owners, triangulation.get_communicator(), owners);
    return owners;
  }



#define INSTANTIATE(dim)                                                     \
  template std::vector<unsigned int> cell_weights<dim>(const Mesh<dim> &,    \
                                                       const unsigned int);  \
  template std::unique_ptr<parallel::TriangulationBase<dim>> partition<dim>( \
    const Mesh<dim> &,                                                       \
    const std::vector<unsigned int> &,                                       \
    const Partitioner,                                                       \
    const MPI_Comm);                                                         \
  template std::vector<types::subdomain_id> find_cell_owners<dim>(           \
    const parallel::TriangulationBase<dim> &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
