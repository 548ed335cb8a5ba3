#include <sandglass/continuum/in_plane_gradient_operator.h>

#include <gtest/gtest.h>

#include <random>

#include "random_engine.h"

using namespace Sandglass;

namespace
{
  /// An operator with random shape functions, moved to the configuration that a
  /// random gradient H leads to.
  template <int n_dofs>
  struct MovedOperator
  {
    explicit MovedOperator(const bool has_hoop)
    {
      for (unsigned int v = 0; v < n_dofs / 2; ++v)
        at_start.set_node(v,
                          std::array<double, 2>{
                            {uniform(engine), uniform(engine)}},
                          has_hoop ? 1. + uniform(engine) : 0.);
      H = 0.1 * random<5, 1>();
      if (!has_hoop)
        H[GradientComponent::hoop] = 0.;
      moved = at_start;
      moved.move_reference(H);
      u = random<n_dofs, 1>();
    }

    template <int n_rows, int n_columns>
    Eigen::Matrix<double, n_rows, n_columns>
    random()
    {
      return Eigen::Matrix<double, n_rows, n_columns>::NullaryExpr(
        [this]() { return uniform(engine); });
    }

    std::mt19937                           engine = random_engine();
    std::uniform_real_distribution<double> uniform{-1., 1.};
    Gradient5                              H;
    InPlaneGradientOperator                at_start, moved;
    /// Displacement increments of the nodes, random as well.
    Eigen::Matrix<double, n_dofs, 1> u;
  };



  /// In-plane part, row d the gradient of component d.
  Eigen::Matrix2d
  in_plane(const Gradient5 &gradient)
  {
    namespace G = GradientComponent;
    Eigen::Matrix2d matrix;
    matrix << gradient[G::xx], gradient[G::xy], gradient[G::yx],
      gradient[G::yy];
    return matrix;
  }



  template <int n_dofs>
  void
  check_adjoint_and_stiffness(const bool has_hoop)
  {
    MovedOperator<n_dofs> cell(has_hoop);
    const Gradient5       stress  = cell.template random<5, 1>();
    const Matrix5         tangent = cell.template random<5, 5>();
    const Gradient5 gradient = cell.moved.template gradient<n_dofs>(cell.u);

    EXPECT_EQ(gradient[GradientComponent::hoop] != 0., has_hoop);
    EXPECT_NEAR(cell.moved.template nodal_forces<n_dofs>(stress).dot(cell.u) /
                  stress.dot(gradient),
                1.,
                1e-12);
    const Eigen::Matrix<double, n_dofs, 1> forces =
      cell.moved.template nodal_forces<n_dofs>(tangent * gradient);
    EXPECT_LT(
      (cell.moved.template stiffness<n_dofs>(tangent) * cell.u - forces).norm(),
      1e-12 * forces.norm());
  }



  // A gradient with respect to the moved configuration is that with respect to
  // the first times the inverse of F = I + H.
  template <int n_dofs>
  void
  check_move(const bool has_hoop)
  {
    MovedOperator<n_dofs> cell(has_hoop);
    const Gradient5 before = cell.at_start.template gradient<n_dofs>(cell.u);
    const Gradient5 after  = cell.moved.template gradient<n_dofs>(cell.u);

    const Eigen::Matrix2d F = Eigen::Matrix2d::Identity() + in_plane(cell.H);
    EXPECT_LT((in_plane(after) * F - in_plane(before)).norm(), 1e-13);
    EXPECT_NEAR(after[GradientComponent::hoop] *
                  (1. + cell.H[GradientComponent::hoop]),
                before[GradientComponent::hoop],
                1e-13);
  }
} // namespace

TEST(InPlaneGradientOperator, ForcesAndStiffnessAreItsTransposes)
{
  for (const bool has_hoop : {false, true})
    {
      check_adjoint_and_stiffness<6>(has_hoop);
      check_adjoint_and_stiffness<8>(has_hoop);
      check_adjoint_and_stiffness<12>(has_hoop);
    }
}



TEST(InPlaneGradientOperator, FollowsTheConfiguration)
{
  for (const bool has_hoop : {false, true})
    {
      check_move<6>(has_hoop);
      check_move<8>(has_hoop);
      check_move<12>(has_hoop);
    }
}
