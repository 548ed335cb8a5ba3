#ifndef sandglass_flow_updated_lagrangian_rezoning_cut_off_h
#define sandglass_flow_updated_lagrangian_rezoning_cut_off_h

#include <sandglass/flow/updated_lagrangian/rezoning/size_field.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_mesh.h>

#include <vector>

namespace Sandglass
{
  /// What is left of a mesh, and what is not.
  struct CutOff
  {
    TriangleMesh mesh;
    /// Of each cell and node that is left, its number before.
    std::vector<unsigned int> cells, nodes;
    double       mass_below   = 0.; ///< that has passed the level, in kg
    double       mass_slivers = 0.; ///< in bodies too small to keep, in kg
    double       mass_spoilt = 0.; ///< of cells that were not to be kept, in kg
    unsigned int n_cells_spoilt = 0;
    unsigned int n_cells_below  = 0;
    unsigned int n_cells_sliver = 0;

    bool
    is_cut() const
    {
      return n_cells_below + n_cells_sliver + n_cells_spoilt > 0;
    }
  };

  /**
   * Remove the cells of which no point is above a level, and then the bodies
   * that are smaller than a share of a new element. What they bounded becomes
   * free surface. A node in which bodies touch is doubled.
   *
   * @param masses          of the cells, in kg.
   * @param level           y in m.
   * @param size            of new elements, which are taken as equilateral.
   * @param smallest_share  of a new element's area.
   * @param is_spoilt       cells that are removed first; empty: none.
   */
  CutOff
  cut_off(const TriangleMesh        &mesh,
          const std::vector<double> &masses,
          const double               level,
          const SizeField           &size,
          const double               smallest_share,
          const std::vector<bool>   &is_spoilt = {});
} // namespace Sandglass

#endif
