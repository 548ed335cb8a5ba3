#include <sandglass/choices.h>
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
      constexpr unsigned int n_directions = dim == 2 ? 2 : 8;

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
    // Forces that are closer to a plane than this span nothing beyond it.
    constexpr double smallest_determinant = 1e-8;

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

    std::vector<bool> is_chosen(forces.size(), false);
    std::fill_n(is_chosen.begin(),
                std::min<std::size_t>(dim, forces.size()),
                true);
    do
      {
        Eigen::Matrix<double, dim, dim> choice;
        unsigned int                    column = 0;
        for (unsigned int i = 0; i < forces.size(); ++i)
          if (is_chosen[i])
            {
              for (unsigned int d = 0; d < dim; ++d)
                choice(d, column) = forces[i][d];
              ++column;
            }
        if (column == dim &&
            std::abs(choice.determinant()) > smallest_determinant)
          coordinates.push_back(choice.inverse());
      }
    while (std::prev_permutation(is_chosen.begin(), is_chosen.end()));
  }



#define INSTANTIATE(dim) template class FrictionCones<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
