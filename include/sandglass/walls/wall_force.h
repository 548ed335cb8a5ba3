#ifndef sandglass_walls_wall_force_h
#define sandglass_walls_wall_force_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <sandglass/continuum/formulation.h>
#include <sandglass/scene/boundary_role.h>

#include <vector>

namespace Sandglass
{
  /**
   * Force between one stretch of wall and the material at one node. Both stages
   * report such forces; observers turn them into tractions.
   */
  template <int dim>
  struct WallForce
  {
    dealii::Point<dim>     position;
    BoundaryRole           role;
    dealii::Tensor<1, dim> normal;         ///< outward from the material
    double                 tributary_area; ///< in m^2 (plane: per m of depth)
    /// In N (plane strain: per metre of depth), compression positive.
    double normal_force;
    /// In N, along wall_tangent(normal): positive when it pushes material up.
    double tangential_force;
  };

  /**
   * Unit tangent of a wall: the normal turned by 90 degrees so that it points
   * up, or along +x on a horizontal wall.
   */
  inline dealii::Tensor<1, 2>
  wall_tangent(const dealii::Tensor<1, 2> &normal)
  {
    dealii::Tensor<1, 2> tangent{{-normal[1], normal[0]}};
    const bool             points_down = tangent[1] < -1e-12;
    const bool points_left = std::abs(tangent[1]) <= 1e-12 && tangent[0] < 0.;
    return points_down || points_left ? -1. * tangent : tangent;
  }
} // namespace Sandglass

#endif
