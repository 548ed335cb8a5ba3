#ifndef sandglass_flow_updated_lagrangian_equilibrium_checkpoint_templates_h
#define sandglass_flow_updated_lagrangian_equilibrium_checkpoint_templates_h

#include <deal.II/base/mpi.h>

#include <sandglass/flow/updated_lagrangian/material_equilibrium.h>

#include <boost/serialization/vector.hpp>

#include <vector>

namespace Sandglass
{
  template <typename Kinematics, typename Law>
  void
  MaterialEquilibrium<Kinematics, Law>::save(
    boost::archive::binary_oarchive &archive) const
  {
    std::vector<SavedPoint> of_rank, all;
    for (const auto &local_cell : grid.local_cells)
      if (local_cell.cell->is_locally_owned())
        for (unsigned int q = 0; q < grid.quadrature.size(); ++q)
          {
            const unsigned int i = grid.point_index(*local_cell.cell, q);
            of_rank.push_back(
              {i, points[i], gradient_operators[i], volumes[i]});
          }
    for (const auto &part :
         Utilities::MPI::gather(grid.triangulation.get_communicator(), of_rank))
      all.insert(all.end(), part.begin(), part.end());
    archive << all;
  }



  template <typename Kinematics, typename Law>
  void
  MaterialEquilibrium<Kinematics, Law>::load(
    boost::archive::binary_iarchive &archive)
  {
    std::vector<SavedPoint> all;
    archive >> all;
    for (const SavedPoint &saved : all)
      {
        points[saved.index]             = saved.point;
        gradient_operators[saved.index] = saved.gradient_operator;
        volumes[saved.index]            = saved.volume;
      }
  }
} // namespace Sandglass

#endif
