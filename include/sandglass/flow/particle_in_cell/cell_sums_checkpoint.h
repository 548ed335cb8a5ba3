#ifndef sandglass_flow_particle_in_cell_cell_sums_checkpoint_h
#define sandglass_flow_particle_in_cell_cell_sums_checkpoint_h

#include <sandglass/flow/particle_in_cell/cell_stiffness.h>
#include <sandglass/flow/particle_in_cell/nodal_sums.h>
#include <sandglass/flow/particle_in_cell/volumetric_average.h>

#include <vector>

namespace Sandglass
{
  /**
   * What a checkpoint holds of each filled cell: its index and the sums over
   * its particles, in the order of the cells. Those that steps have added up
   * would be others if they were found anew, by rounding.
   *
   * @param stiffness  of the cells, if it changes; else nullptr.
   */
  template <typename Setting>
  std::vector<double>
  pack_cell_sums(const ParticleBlocks<typename Setting::Layout> &blocks,
                 const NodalSums<Setting>                       &nodal_sums,
                 const VolumetricAverage<Setting>               &average,
                 const CellStiffness<Setting>                   *stiffness)
  {
    std::vector<double> packed;
    for_each_filled_cell(blocks, [&](const unsigned int cell) {
      packed.push_back(cell);
      const auto pack = [&packed, cell](const auto &cells) {
        const auto &values = cells[cell].values;
        packed.insert(packed.end(), values.begin(), values.end());
      };
      pack(nodal_sums.cells);
      if (average.cells)
        pack(*average.cells);
      if (stiffness != nullptr)
        {
          const Elasticity &elasticity = stiffness->elasticity(cell);
          packed.push_back(elasticity.lame_modulus);
          packed.push_back(elasticity.shear_modulus);
        }
    });
    return packed;
  }



  /// Set the sums to those that pack_cell_sums() has packed, of all ranks'
  /// cells.
  template <typename Setting>
  void
  unpack_cell_sums(const std::vector<double>  &packed,
                   NodalSums<Setting>         &nodal_sums,
                   VolumetricAverage<Setting> &average,
                   CellStiffness<Setting>     *stiffness)
  {
    for (auto next = packed.begin(); next != packed.end();)
      {
        const auto cell = static_cast<unsigned int>(*next++);
        next            = nodal_sums.cells.unpack(cell, next);
        if (average.cells)
          next = average.cells->unpack(cell, next);
        if (stiffness != nullptr)
          {
            Elasticity elasticity(0., 0.);
            elasticity.lame_modulus  = *next++;
            elasticity.shear_modulus = *next++;
            stiffness->set_elasticity(cell, elasticity);
          }
      }
  }
} // namespace Sandglass

#endif
