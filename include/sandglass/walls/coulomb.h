#ifndef sandglass_walls_coulomb_h
#define sandglass_walls_coulomb_h

#include <deal.II/base/tensor.h>

namespace Sandglass
{
  /// What a wall does along its plane.
  template <int dim>
  struct Friction
  {
    /// On the material, in N or, where impulses are compared, in N s.
    dealii::Tensor<1, dim> force;
    bool                   is_sliding;
  };

  /**
   * Coulomb's law: the force that would make the material stick, as far as the
   * limit lets it (paper, Section 4.2). A limit of zero, that of a smooth wall,
   * counts as sliding.
   *
   * @param trial  force at which the material sticks, in the wall's plane.
   * @param limit  mu times the normal force, >= 0, in the same units.
   */
  template <int dim>
  Friction<dim>
  coulomb(const dealii::Tensor<1, dim> &trial, const double limit)
  {
    const double norm = trial.norm();
    if (norm < limit)
      return {trial, false};
    return {norm > 0. ? (limit / norm) * trial : trial, true};
  }
} // namespace Sandglass

#endif
