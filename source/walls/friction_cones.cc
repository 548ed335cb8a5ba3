#include <sandglass/choices/dimensions.h>
#include <sandglass/walls/friction_cones.h>

#include <cmath>

namespace Sandglass
{
  namespace
  {
    template <int dim>
    using Forces = std::vector<Tensor<1, dim>>;



    /// Unit vectors in the plane of a wall, in directions enough for a pyramid
    /// to stand for its cone.
    template <int dim>
    Forces<dim>
    directions_in_plane(const Support<dim> &support)
    {
      constexpr unsigned int n_directions = dim == 2 ? 2 : 16;

      // The coordinate that the normal has least of gives the first direction.
      unsigned int least = 0;
      for (unsigned int d = 1; d < dim; ++d)
        if (std::abs(support.normal[d]) < std::abs(support.normal[least]))
          least = d;
      Tensor<1, dim> first;
      first[least] = 1.;
      first        = support.tangential(first);
      first /= first.norm();
      if constexpr (dim == 2)
        return {first, -first};

      Forces<dim> directions;
      if constexpr (dim == 3)
        {
          const Tensor<1, dim> second = cross_product_3d(support.normal, first);
          for (unsigned int i = 0; i < n_directions; ++i)
            {
              const double angle = 2. * numbers::PI * i / n_directions;
              directions.push_back(std::cos(angle) * first +
                                   std::sin(angle) * second);
            }
        }
      return directions;
    }



    /// What spans a wall's cone.
    template <int dim>
    Forces<dim>
    spanning_forces(const Support<dim> &support)
    {
      if (support.friction_coefficient == 0. || support.velocity.norm() > 0.)
        return {-support.normal};
      Forces<dim> forces;
      for (const auto &direction : directions_in_plane(support))
        forces.push_back(support.friction_coefficient * direction -
                         support.normal);
      return forces;
    }
  } // namespace



  template <int dim>
  FrictionCones<dim>::FrictionCones(const Supports<dim> &supports)
  {
    Forces<dim>  forces;
    unsigned int n_walls = 0;
    for (const Support<dim> &support : supports)
      if (!support.is_axis)
        {
          ++n_walls;
          for (const auto &force : spanning_forces(support))
            forces.push_back(force);
        }
    if (n_walls < 2)
      return;

    for (unsigned int i = 0; i < forces.size(); ++i)
      if constexpr (dim == 2)
        add_side(cross_product_2d(forces[i]), forces);
      else
        for (unsigned int j = 0; j < i; ++j)
          add_side(cross_product_3d(forces[i], forces[j]), forces);
  }



  template <int dim>
  void
  FrictionCones<dim>::add_side(const Tensor<1, dim> &normal,
                               const Forces<dim>    &forces)
  {
    // Forces that are closer to a plane than this span nothing beyond it.
    constexpr double smallest = 1e-8;

    const double norm = normal.norm();
    if (norm < smallest)
      return;
    bool has_before = false, has_behind = false;
    for (const auto &force : forces)
      {
        const double distance = normal * force / norm;
        has_before            = has_before || distance > smallest;
        has_behind            = has_behind || distance < -smallest;
      }
    has_volume = has_volume || has_before || has_behind;
    if (has_before && has_behind)
      return;
    const Tensor<1, dim> side = (has_before ? 1. : -1.) / norm * normal;
    for (const auto &known : sides)
      if ((known - side).norm() < smallest)
        return;
    if (has_before || has_behind)
      sides.push_back(side);
  }



#define INSTANTIATE(dim) template class FrictionCones<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
