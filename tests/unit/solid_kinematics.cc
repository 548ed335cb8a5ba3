#include <sandglass/continuum/in_plane_increment.h>
#include <sandglass/continuum/solid.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "random_engine.h"

using namespace Sandglass;

namespace
{
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

  class SolidKinematics : public testing::Test
  {
  protected:
    template <int n>
    Eigen::Matrix<double, n, 1>
    random(const double size)
    {
      return size * Eigen::Matrix<double, n, 1>::NullaryExpr(
                      [this]() { return uniform(engine); });
    }

    static Eigen::Matrix3d
    matrix_of(const SymmetricComponents<6> &s)
    {
      Eigen::Matrix3d m;
      m << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
      return m;
    }

    static SolidIncrement<double>::Gradient
    array_of(const Eigen::Matrix3d &matrix)
    {
      SolidIncrement<double>::Gradient result;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          result[i][j] = matrix(i, j);
      return result;
    }

    std::mt19937                           engine = random_engine();
    std::uniform_real_distribution<double> uniform{-1., 1.};
  };

  constexpr StressIntegration integrations[] =
    {StressIntegration::start_of_step, StressIntegration::middle_of_step};
} // namespace

TEST_F(SolidKinematics, FiniteRotationTurnsRigidlyAndLeavesNoStrain)
{
  for (unsigned int i = 0; i < 20; ++i)
    {
      const Eigen::Vector3d axis  = random<3>(1.).normalized();
      const double          angle = 2. * uniform(engine);
      const Eigen::Matrix3d R =
        Eigen::AngleAxisd(angle, axis).toRotationMatrix();
      const SolidIncrement<double> increment(array_of(
                                               R - Eigen::Matrix3d::Identity()),
                                             0.,
                                             StressIntegration::middle_of_step);
      EXPECT_LT(increment.strain.norm(), 1e-14);
      EXPECT_NEAR(increment.jacobian, 1., 1e-14);
      const SymmetricComponents<6> stress = random<6>(1e3);
      const Eigen::Matrix3d turned = R * matrix_of(stress) * R.transpose();
      EXPECT_LT((matrix_of(rotate(stress, increment.rotation)) - turned).norm(),
                1e-11);
    }
}

TEST_F(SolidKinematics, SmallRotationIsThatOfTheFiniteOneToFirstOrder)
{
  const SymmetricComponents<6> stress = random<6>(1.);
  const auto                   spin   = random<3>(1.);
  double                       last   = 0.;
  for (const double size : {1e-2, 5e-3})
    {
      const std::array<double, 3> w{
        {size * spin[0], size * spin[1], size * spin[2]}};
      const double difference =
        (rotate(stress, SolidRotation<double>::forward_euler(w)) -
         rotate(stress, SolidRotation<double>::hughes_winget(w)))
          .norm();
      if (last > 0.)
        {
          EXPECT_NEAR(last / difference, 4., 0.1);
        }
      last = difference;
    }
}

TEST_F(SolidKinematics, HalfOfARotationTwiceIsTheWhole)
{
  const SymmetricComponents<6> stress = random<6>(1.);
  const auto                   spin   = random<3>(1.);
  const std::array<double, 3>  w{{spin[0], spin[1], spin[2]}};
  const auto half  = SolidRotation<double>::half_hughes_winget(w);
  const auto twice = rotate(rotate(stress, half), half);
  EXPECT_LT(
    (twice - rotate(stress, SolidRotation<double>::hughes_winget(w))).norm(),
    1e-14);
}

// With the strain and rotation of a section, those of plane strain.
TEST_F(SolidKinematics, SectionDeformsAsInPlaneStrain)
{
  for (const auto integration : integrations)
    {
      const auto                                 g = random<4>(0.1);
      const std::array<std::array<double, 2>, 2> in_plane{
        {{{g[0], g[1]}}, {{g[2], g[3]}}}};
      Eigen::Matrix3d in_space = Eigen::Matrix3d::Zero();
      in_space.topLeftCorner<2, 2>() << g[0], g[1], g[2], g[3];
      const InPlaneIncrement<double> plane(in_plane, 0., integration);
      const SolidIncrement<double>   solid(array_of(in_space), 0., integration);
      EXPECT_LT((solid.strain.head<4>() - plane.strain).norm(), 1e-16);
      EXPECT_EQ(solid.strain.tail<2>().norm(), 0.);
      EXPECT_NEAR(solid.jacobian, plane.jacobian, 1e-15);

      SymmetricComponents<6> stress = random<6>(1.);
      stress.tail<2>().setZero();
      const SymmetricComponents<4> section = stress.head<4>();
      const SymmetricComponents<6> turned  = rotate(stress, solid.rotation);
      EXPECT_LT((turned.head<4>() - rotate(section, plane.rotation)).norm(),
                1e-15);
      EXPECT_EQ(turned.tail<2>().norm(), 0.);
    }
}

TEST_F(SolidKinematics, TangentIsTheDerivativeOfThePiolaStress)
{
  constexpr double h = 1e-6;
  for (const auto integration : integrations)
    {
      // Of a linear law, so that the material's part is known.
      const auto by_strain = Eigen::Matrix<double, 6, 6>::NullaryExpr([this]() {
                               return uniform(engine);
                             }).eval();
      const SymmetricComponents<6> before = random<6>(1.);
      const auto stress_at = [&](const Gradient9 &H) -> SymmetricComponents<6> {
        const auto step = SolidResponse::increment(H, integration);
        return rotate(before, step.rotation) + by_strain * step.strain;
      };
      const Gradient9          H = random<9>(0.1);
      const MaterialTangent<6> material{Eigen::Matrix<double, 6, 6>::Identity(),
                                        by_strain};
      const Matrix9            tangent =
        SolidResponse::tangent(before, stress_at(H), H, material, integration);
      for (int c = 0; c < 9; ++c)
        {
          Gradient9 more = H, less = H;
          more[c] += h;
          less[c] -= h;
          const Gradient9 difference =
            (SolidResponse::piola_stress(stress_at(more), more) -
             SolidResponse::piola_stress(stress_at(less), less)) /
            (2. * h);
          EXPECT_LT((tangent.col(c) - difference).norm(), 1e-8);
        }
    }
}

TEST_F(SolidKinematics, ForcesWorkOnGradientsAlsoAfterTheReferenceHasMoved)
{
  constexpr int               n_dofs = 24;
  SolidGradientOperator       at_start;
  Eigen::Matrix<double, 3, 8> G;
  for (int v = 0; v < 8; ++v)
    {
      G.col(v) = random<3>(1.);
      at_start.set_node(v, G.col(v), 0.);
    }
  const Gradient9       H     = random<9>(0.1);
  SolidGradientOperator moved = at_start;
  moved.move_reference(H);

  const Eigen::Matrix<double, n_dofs, 1> u        = random<n_dofs>(1.);
  Eigen::Matrix3d                        gradient = Eigen::Matrix3d::Zero();
  for (int v = 0; v < 8; ++v)
    gradient += u.segment<3>(3 * v) * G.col(v).transpose();
  const Gradient9 numbers = at_start.gradient<n_dofs>(u);
  EXPECT_LT((Eigen::Map<const RowMajor>(numbers.data()) - gradient).norm(),
            1e-14);
  // du/dx = du/dX F^-1
  const Eigen::Matrix3d F =
    Eigen::Matrix3d::Identity() + Eigen::Map<const RowMajor>(H.data());
  const Gradient9 moved_numbers = moved.gradient<n_dofs>(u);
  EXPECT_LT(
    (Eigen::Map<const RowMajor>(moved_numbers.data()) * F - gradient).norm(),
    1e-13);

  const Gradient9 piola = random<9>(1.);
  EXPECT_NEAR(moved.nodal_forces<n_dofs>(piola).dot(u),
              piola.dot(moved_numbers),
              1e-13);
  const Matrix9 tangent =
    Matrix9::NullaryExpr([this]() { return uniform(engine); });
  EXPECT_LT((moved.stiffness<n_dofs>(tangent) * u -
             moved.nodal_forces<n_dofs>(tangent * moved_numbers))
              .norm(),
            1e-12);
}

TEST_F(SolidKinematics, NodalForceIsStressTimesGradient)
{
  const SymmetricComponents<6> stress   = random<6>(1.);
  const Eigen::Vector3d        gradient = random<3>(1.);
  const auto                   force =
    Solid::nodal_force(stress.data(),
                       std::array<double, 3>{
                         {gradient[0], gradient[1], gradient[2]}});
  EXPECT_LT((Eigen::Vector3d(force[0], force[1], force[2]) -
             matrix_of(stress) * gradient)
              .norm(),
            1e-15);
}
