#ifndef sandglass_walls_wall_force_h
#define sandglass_walls_wall_force_h

#include <deal.II/base/tensor.h>

#include <sandglass/walls/wall.h>

namespace Sandglass
{
  /// Force between one wall and the material at one node, of one direction in
  /// which the wall holds the node.
  template <int dim>
  struct WallForce
  {
    WallId                 wall;
    unsigned int           vertex; ///< of the scene's mesh
    dealii::Tensor<1, dim> normal; ///< outward from the material
    double                 area;   ///< in m^2 (plane: per m of depth)
    dealii::Tensor<1, dim> force;  ///< on the material, in N (per m of depth)

    /// In N, compression positive.
    double
    normal_force() const
    {
      return -(force * normal);
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &wall &vertex &normal &area &force;
    }
  };
} // namespace Sandglass

#endif
