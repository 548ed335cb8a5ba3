#ifndef sandglass_continuum_in_plane_h
#define sandglass_continuum_in_plane_h

#include <sandglass/continuum/formulation.h>
#include <sandglass/continuum/in_plane_gradient_operator.h>
#include <sandglass/continuum/in_plane_increment.h>

#include <array>
#include <cmath>

namespace Sandglass
{
  /**
   * What plane strain and axisymmetry share: a displacement in the plane (x, y)
   * alone. CONTRIBUTING.md lists what a kinematics has to have.
   */
  struct InPlane
  {
    /// Space dimension of the grid and of the particles' positions.
    static constexpr int dim = 2;
    /// Components of stress and strain that may differ from zero.
    static constexpr int n_components = 4;

    template <typename Number = double>
    using Stress = SymmetricComponents<n_components, Number>;
    /// A vector in the plane.
    template <typename Number = double>
    using Vector = std::array<Number, dim>;
    /// Of one component in each row.
    template <typename Number = double>
    using Gradient = std::array<Vector<Number>, dim>;

    template <typename Number = double>
    using Increment = InPlaneIncrement<Number>;

    /// The two of a load step of the updated Lagrangian formulation.
    using Response         = InPlaneResponse;
    using GradientOperator = InPlaneGradientOperator;

    /**
     * Stress times a shape function's gradient: with stress times volume the
     * force on the function's node (eq. 9), in N, but for the hoop stress's.
     *
     * @param stress  in the order of `force_components`.
     */
    template <typename Number, typename GradientVector>
    static Vector<Number>
    nodal_force(const Number *stress, const GradientVector &gradient)
    {
      const Number &xx = stress[0], &yy = stress[1], &xy = stress[2];
      return {{xx * gradient[0] + xy * gradient[1],
               xy * gradient[0] + yy * gradient[1]}};
    }

    /// Unit vector along which a velocity gradient stretches most.
    static Vector<>
    principal_extension(const Gradient<> &gradient)
    {
      const double angle = 0.5 * std::atan2(gradient[0][1] + gradient[1][0],
                                            gradient[0][0] - gradient[1][1]);
      return {{std::cos(angle), std::sin(angle)}};
    }
  };
} // namespace Sandglass

#endif
