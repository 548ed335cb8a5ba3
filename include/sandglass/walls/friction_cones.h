#ifndef sandglass_walls_friction_cones_h
#define sandglass_walls_friction_cones_h

#include <sandglass/walls/support.h>

#include <Eigen/Dense>

#include <vector>

namespace Sandglass
{
  /**
   * Coulomb's cones of the walls that meet at one node, added up: all forces
   * that the walls together can exert on material which doesn't slip.
   *
   * A wall's cone is spanned by the forces at its limit of friction; in the
   * plane these are two. A wall that moves rubs even if the material stays
   * where it is, so nothing but its normal counts.
   */
  template <int dim>
  class FrictionCones
  {
  public:
    /// Without any wall: contains nothing.
    FrictionCones() = default;

    explicit FrictionCones(const Supports<dim> &supports);

    /// Whether there are several walls.
    bool
    are_several() const
    {
      return !coordinates.empty();
    }

    /// Whether the walls together can exert this force on the material.
    bool
    contain(const Tensor<1, dim> &force) const
    {
      Eigen::Matrix<double, dim, 1> components;
      for (unsigned int d = 0; d < dim; ++d)
        components[d] = force[d];
      for (const auto &of_simplex : coordinates)
        if ((of_simplex * components).minCoeff() >= 0.)
          return true;
      return false;
    }

  private:
    /// A force's coordinates along each choice of dim spanning forces: the sum
    /// of the cones is the union of the cones over these choices.
    std::vector<Eigen::Matrix<double, dim, dim>> coordinates;
  };
} // namespace Sandglass

#endif
