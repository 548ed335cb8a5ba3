#ifndef sandglass_material_numerical_tangent_h
#define sandglass_material_numerical_tangent_h

#include <sandglass/continuum/material_tangent.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Sandglass
{
  /**
   * Tangent of a law's correct() by central differences, four at a time.
   *
   * @param stress,state  at the increment's start, stress turned and in Pa.
   * @param strain  the increment, which correct() must take as it is.
   * @param stress_scale  in Pa, positive: what is a change of this stress at
   * all. Differences are taken with a thousandth of it, and with the strain to
   * which the law answers by about as much. This is far above what an adaptive
   * integration adds to the result, and far below what bends it.
   */
  template <typename Law, int n, std::size_t n_state>
  MaterialTangent<n>
  numerical_tangent(const Law                         &law,
                    const Eigen::Matrix<double, n, 1> &stress,
                    const std::array<double, n_state> &state,
                    const Eigen::Matrix<double, n, 1> &strain,
                    const double                       stress_scale)
  {
    constexpr double relative_difference = 1e-3;
    const double     stress_step         = relative_difference * stress_scale;
    const double     strain_step =
      stress_step / law.stiffness_bound(stress, state).confined_modulus();

    // The columns of both matrices, first by stress and then by strain, each
    // with both signs: two columns in a block of four.
    constexpr int       n_columns = 2 * n;
    MaterialTangent<n>  tangent;
    ComponentMatrix<n> *matrices[2] = {&tangent.by_stress, &tangent.by_strain};
    const double        steps[2]    = {stress_step, strain_step};
    for (int first = 0; first < n_columns; first += 2)
      {
        SymmetricComponents<n, Lanes> stresses = stress.template cast<Lanes>();
        SymmetricComponents<n, Lanes> strains  = strain.template cast<Lanes>();
        std::array<Lanes, n_state>    states;
        for (std::size_t i = 0; i < n_state; ++i)
          states[i] = Lanes(state[i]);
        for (int column = first; column < first + 2; ++column)
          {
            alignas(Lanes) double signs[Lanes::n] = {};
            signs[2 * (column - first)]           = 1.;
            signs[2 * (column - first) + 1]       = -1.;
            const bool by_strain                  = column >= n;
            (by_strain ? strains : stresses)[column % n] +=
              Lanes(steps[by_strain]) * Lanes::load(signs);
          }
        law.correct(stresses, states, strains);
        for (int column = first; column < first + 2; ++column)
          for (int c = 0; c < n; ++c)
            (*matrices[column >= n])(c, column % n) =
              (stresses[c][2 * (column - first)] -
               stresses[c][2 * (column - first) + 1]) /
              (2. * steps[column >= n]);
      }
    return tangent;
  }
} // namespace Sandglass

#endif
