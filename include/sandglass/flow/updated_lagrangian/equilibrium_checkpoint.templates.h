#ifndef sandglass_flow_updated_lagrangian_equilibrium_checkpoint_templates_h
#define sandglass_flow_updated_lagrangian_equilibrium_checkpoint_templates_h

#include <deal.II/base/mpi.h>

#include <sandglass/base/gather.h>
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
    std::vector<SavedPoint> of_rank;
    for (const auto &local_cell : grid.local_cells)
      if (local_cell.cell->is_locally_owned())
        for (unsigned int q = 0; q < grid.quadrature.size(); ++q)
          {
            const unsigned int i = grid.point_index(*local_cell.cell, q);
            of_rank.push_back(
              {i, points[i], gradient_operators[i], volumes[i]});
          }
    archive << gather_on_first(of_rank, grid.triangulation.get_communicator());
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
