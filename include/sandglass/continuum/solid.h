#ifndef sandglass_continuum_solid_h
#define sandglass_continuum_solid_h

#include <sandglass/continuum/formulation.h>
#include <sandglass/continuum/solid_gradient_operator.h>
#include <sandglass/continuum/solid_increment.h>

#include <Eigen/Eigenvalues>

#include <array>

namespace Sandglass
{
  /// Three dimensions: the grid is space itself, y up.
  struct Solid
  {
    static constexpr Formulation formulation = Formulation::three_dimensions;

    static constexpr int  dim             = 3;
    static constexpr int  n_components    = 6;
    static constexpr bool has_hoop_strain = false;

    /// All components do work, in the order in which stress has them.
    static constexpr std::array<int, 6> force_components = {{Component::xx,
                                                             Component::yy,
                                                             Component::zz,
                                                             Component::xy,
                                                             Component::yz,
                                                             Component::xz}};

    template <typename Number = double>
    using Stress = SymmetricComponents<n_components, Number>;
    template <typename Number = double>
    using Vector = std::array<Number, dim>;
    /// Of one component in each row.
    template <typename Number = double>
    using Gradient = std::array<Vector<Number>, dim>;

    template <typename Number = double>
    using Increment = SolidIncrement<Number>;

    /// The two of a load step of the updated Lagrangian formulation.
    using Response         = SolidResponse;
    using GradientOperator = SolidGradientOperator;

    /// Volume that a unit of the grid's volume stands for.
    template <typename Position>
    static double
    measure(const Position &)
    {
      return 1.;
    }

    /**
     * Stress times a shape function's gradient: with stress times volume the
     * force on the function's node (eq. 9), in N.
     *
     * @param stress  in the order of `force_components`.
     */
    template <typename Number, typename GradientVector>
    static Vector<Number>
    nodal_force(const Number *stress, const GradientVector &gradient)
    {
      const Number &xx = stress[0], &yy = stress[1], &zz = stress[2],
                   &xy = stress[3], &yz = stress[4], &xz = stress[5];
      return {{xx * gradient[0] + xy * gradient[1] + xz * gradient[2],
               xy * gradient[0] + yy * gradient[1] + yz * gradient[2],
               xz * gradient[0] + yz * gradient[1] + zz * gradient[2]}};
    }

    /// Unit vector along which a velocity gradient stretches most.
    static Vector<>
    principal_extension(const Gradient<> &gradient)
    {
      Eigen::Matrix3d rate;
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          rate(i, j) = 0.5 * (gradient[i][j] + gradient[j][i]);
      // Eigenvalues come in increasing order.
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(rate);
      const Eigen::Vector3d largest = solver.eigenvectors().col(dim - 1);
      return {{largest[0], largest[1], largest[2]}};
    }
  };
} // namespace Sandglass

#endif
