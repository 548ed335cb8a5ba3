#ifndef sandglass_element_test_material_point_h
#define sandglass_element_test_material_point_h

#include <sandglass/continuum/in_plane_increment.h>
#include <sandglass/material/state_variable.h>

#include <array>
#include <cstring>
#include <limits>

namespace Sandglass
{
  /**
   * A material point in the uniform deformation x = l_x X + gamma Y, y = l_y Y,
   * z = l_z Z. Simple shear has no lateral strain: l_x is 1 where gamma isn't
   * 0.
   */
  template <typename Law>
  struct MaterialPoint
  {
    SymmetricComponents<4> stress; ///< in Pa, tension positive
    LawState<Law, double>  state;

    std::array<double, 3> stretch = {{1., 1., 1.}}; ///< l, of length now
    double                shear   = 0.;             ///< gamma

    /// The one strain that the test drives, as it was asked for.
    double driven_strain = 0.;

    /// tr(strain) with compression positive: share of the initial volume lost.
    double
    volumetric_strain() const
    {
      return 1. - stretch[0] * stretch[1] * stretch[2];
    }
  };

  /// Gradient of a displacement increment with respect to the positions at its
  /// start.
  struct UniformGradient
  {
    std::array<double, 3> normal = {{0., 0., 0.}};
    double                shear  = 0.; ///< du_x/dy

    /// Whether nothing is turned inside out, nor even comes near.
    bool
    is_moderate() const
    {
      for (const double component : normal)
        if (!(component > -0.9 && component < 9.))
          return false;
      return std::abs(shear) < 10.;
    }
  };

  /**
   * A point after an increment, of which the law gets what a particle's would
   * be: the stress is turned first, by Jaumann's rate.
   *
   * @param time_step  in s.
   */
  template <typename Law>
  MaterialPoint<Law>
  deformed(MaterialPoint<Law>      point,
           const UniformGradient  &gradient,
           const Law              &law,
           const StressIntegration integration,
           const double            time_step)
  {
    const std::array<std::array<double, 2>, 2> in_plane = {
      {{{gradient.normal[0], gradient.shear}}, {{0., gradient.normal[1]}}}};
    const InPlaneIncrement<double> increment(in_plane,
                                             gradient.normal[2],
                                             integration);
    point.stress          = rotate(point.stress, increment.rotation);
    const auto prediction = law.predict(increment, time_step);
    law.correct(point.stress, point.state, prediction);

    // F_new = (1 + gradient) F
    point.shear += gradient.shear * point.stretch[1];
    for (int i = 0; i < 3; ++i)
      point.stretch[i] *= 1. + gradient.normal[i];
    return point;
  }

  template <typename Law>
  bool
  is_finite(const MaterialPoint<Law> &point)
  {
    for (const double number : point.state)
      if (!std::isfinite(number))
        return false;
    return point.stress.allFinite();
  }

  /// The law's state variable of that name; not a number if it has none.
  template <typename Law>
  double
  state_variable(const LawState<Law, double> &state, const char *const name)
  {
    std::size_t first = 0;
    for (const StateVariable &variable : Law::state_variables)
      {
        if (std::strcmp(variable.name, name) == 0)
          return state[first];
        first += variable.n_components;
      }
    return std::numeric_limits<double>::quiet_NaN();
  }
} // namespace Sandglass

#endif
