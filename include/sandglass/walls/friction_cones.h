#ifndef sandglass_walls_friction_cones_h
#define sandglass_walls_friction_cones_h

#include <sandglass/walls/support.h>

#include <vector>

namespace Sandglass
{
  /**
   * Coulomb's cones of the walls that meet at one node, added up: all forces
   * that the walls together can exert on material which doesn't slip.
   *
   * A wall's cone is spanned by the forces at its limit of friction; in the
   * plane these are two, in space sixteen stand for the circle. A wall that
   * moves rubs even if the material stays where it is, so nothing but its
   * normal counts.
   */
  template <int dim>
  class FrictionCones
  {
  public:
    /// Without any wall: contains nothing.
    FrictionCones() = default;

    explicit FrictionCones(const Supports<dim> &supports);

    /// Whether there are several walls whose cones have a volume (in the plane,
    /// an area) together.
    bool
    are_several() const
    {
      return has_volume;
    }

    /// Whether the walls together can exert this force on the material.
    bool
    contain(const Tensor<1, dim> &force) const
    {
      if (!has_volume)
        return false;
      for (const Tensor<1, dim> &side : sides)
        if (side * force < 0.)
          return false;
      return true;
    }

  private:
    /// A candidate for a side, along dim - 1 of the spanning forces.
    void
    add_side(const Tensor<1, dim>              &normal,
             const std::vector<Tensor<1, dim>> &forces);

    bool has_volume = false;

    /// Inward normals of the sum's sides; none if it is all of space.
    std::vector<Tensor<1, dim>> sides;
  };
} // namespace Sandglass

#endif
