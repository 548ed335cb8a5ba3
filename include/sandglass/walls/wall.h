#ifndef sandglass_walls_wall_h
#define sandglass_walls_wall_h

#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>

#include <sandglass/walls/boundary_role.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /// Number of a wall: an index into the scene's list of walls.
  using WallId = unsigned int;

  /// The number that no wall has.
  inline constexpr WallId no_wall = static_cast<WallId>(-1);

  /// One wall of the silo: faces of the mesh that have a name in common.
  template <int dim>
  struct Wall
  {
    /// Of the standard part, or of the physical group in a mesh file.
    std::string  name;
    BoundaryRole role;
    /// Of its faces in triangulations.
    dealii::types::boundary_id boundary_id;
    /// mu = tan(wall friction angle)
    double friction_coefficient = 0.;
    /// In its own plane, in m/s.
    dealii::Tensor<1, dim> velocity = {};
  };

  /// What a boundary face is.
  struct BoundaryPart
  {
    BoundaryRole role = BoundaryRole::top;
    WallId       wall = no_wall; ///< if it is one
  };

  /// What the boundary faces with an id are. A wall that the list lacks counts
  /// as none.
  template <int dim>
  BoundaryPart
  boundary_part(const std::vector<Wall<dim>>    &walls,
                const dealii::types::boundary_id id)
  {
    for (WallId wall = 0; wall < walls.size(); ++wall)
      if (walls[wall].boundary_id == id)
        return {walls[wall].role, wall};
    return {id < first_named_boundary ? static_cast<BoundaryRole>(id) :
                                        BoundaryRole::insert,
            no_wall};
  }
} // namespace Sandglass

#endif
