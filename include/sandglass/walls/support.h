#ifndef sandglass_walls_support_h
#define sandglass_walls_support_h

#include <deal.II/base/tensor.h>

#include <sandglass/walls/wall.h>

#include <boost/container/static_vector.hpp>

namespace Sandglass
{
  using namespace dealii;

  /// What one wall has of a support.
  struct WallShare
  {
    WallId wall;
    double area;            ///< in m^2 (plane strain: per metre of depth)
    double of_normal_force; ///< in proportion to the areas
    double of_friction;     ///< in proportion to areas times coefficients
  };

  /**
   * One direction in which the boundary holds a node: the faces around it that
   * have this normal. They may belong to several walls, or to the symmetry
   * axis (or plane), which pulls as well as it pushes and has no friction.
   */
  template <int dim>
  struct Support
  {
    /// As many walls may share a direction at a node.
    static constexpr unsigned int most_walls = 1u << (dim - 1);

    Tensor<1, dim> normal; ///< outward from the material, unit length
    bool           is_axis = false;
    /**
     * Area that belongs to the node: the integral of the node's linear shape
     * function over the faces, per metre of depth (plane strain) or times the
     * circumference 2 pi x (axisymmetric). In m^2.
     */
    double area = 0.;
    /// Mean of the walls', weighted by area.
    double friction_coefficient = 0.;
    /// Mean of the walls', weighted by their friction, in m/s.
    Tensor<1, dim> velocity;

    boost::container::static_vector<WallShare, most_walls> walls;

    /// The part of a vector that lies in the support's plane.
    Tensor<1, dim>
    tangential(const Tensor<1, dim> &vector) const
    {
      return vector - (vector * normal) * normal;
    }
  };

  /// The supports of one node: no more than directions of space.
  template <int dim>
  using Supports = boost::container::static_vector<Support<dim>, dim>;
} // namespace Sandglass

#endif
