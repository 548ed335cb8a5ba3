#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>

#include "random_engine.h"
#include "solid_fixture.h"

using namespace Sandglass;

namespace
{
  using Layout = SolidFixture::Layout;

  constexpr double g = 9.81, degree = dealii::numbers::PI / 180.;

  class SolidMotion : public testing::TestWithParam<CellType>
  {
  protected:
    /// Mean velocity of all particles.
    Tensor<1, 3>
    mean_velocity() const
    {
      return fixture.momentum() / fixture.stage->view().totals().mass_in_silo;
    }

    void
    run_until(const double time)
    {
      while (fixture.stage->view().clock().time < time)
        fixture.stage->step();
    }

    SolidFixture fixture;
  };
} // namespace

INSTANTIATE_TEST_SUITE_P(CellTypes,
                         SolidMotion,
                         testing::Values(CellType::hexahedron,
                                         CellType::tetrahedron));

TEST_P(SolidMotion, FreeFallIsExactAndStressFree)
{
  Box box;
  box.cell_type = GetParam();
  box.upper     = Point<3>(0.4, 2., 0.3);
  box.n         = {{4, 20, 3}};
  box.is_filled = [](const Point<3> &p) { return p[1] > 1.5; };
  fixture.set_time_step(1e-3);
  auto &stage = fixture.start(box.mesh());

  constexpr unsigned int n_steps = 400;
  for (unsigned int step = 0; step < n_steps; ++step)
    stage.step();

  // Velocity and position of the symplectic Euler scheme, without error.
  const double velocity = -g * n_steps * 1e-3;
  const double fall     = g * 1e-6 * n_steps * (n_steps + 1) / 2.;
  fixture.for_each_particle([&](auto id, const auto &position, auto state) {
    const Point<3> start = stage.initial_position(id);
    EXPECT_NEAR(position[0], start[0], 1e-12);
    EXPECT_NEAR(position[1], start[1] - fall, 1e-12);
    EXPECT_NEAR(position[2], start[2], 1e-12);
    EXPECT_NEAR(state[Layout::velocity + 1] / velocity, 1., 1e-12);
    for (unsigned int c = 0; c < 6; ++c)
      EXPECT_NEAR(state[Layout::stress + c] / (1500. * g), 0., 1e-8);
  });
  EXPECT_NEAR(stage.view().totals().mass_in_silo,
              1500. * 0.4 * 0.5 * 0.3,
              1e-9);
}

// A block in the middle of nothing, thrown, spinning and stretched: forces
// between its parts leave momentum as it is, and with the consistent mass
// matrix angular momentum as well. The lumped matrix would not: it puts the
// mass of a particle to the nodes and not to where it is.
TEST_P(SolidMotion, InnerForcesLeaveMomentumAndAngularMomentum)
{
  Box box;
  box.cell_type = GetParam();
  box.n         = {{10, 10, 10}};
  box.is_filled = [](const Point<3> &p) {
    return (p - Point<3>(0.5, 0.5, 0.5)).norm() < 0.28;
  };
  fixture.gravity                          = Tensor<1, 3>();
  fixture.material.young_modulus           = 1e6;
  fixture.material.cohesion                = 1e4;
  fixture.parameters.density_update        = DensityUpdate::paper;
  fixture.parameters.consistent_mass_share = 1.;
  fixture.start(box.mesh());
  const Tensor<1, 3> spin({0.3, -0.5, 0.4}), throw_velocity({0.2, 0.1, -0.1});
  fixture.change_particles([&](auto, const auto &position, auto state) {
    const Tensor<1, 3> arm = position - Point<3>(0.5, 0.5, 0.5);
    const Tensor<1, 3> velocity =
      throw_velocity + cross_product_3d(spin, arm) +
      Tensor<1, 3>({0.1 * arm[0], -0.2 * arm[1], 0.1 * arm[1]});
    for (unsigned int d = 0; d < 3; ++d)
      state[Layout::velocity + d] = velocity[d];
  });
  const Tensor<1, 3> momentum = fixture.momentum(),
                     angular  = fixture.angular_momentum();
  for (unsigned int step = 0; step < 40; ++step)
    fixture.stage->step();
  EXPECT_LT((fixture.momentum() - momentum).norm() / momentum.norm(), 1e-12);
  const double change =
    (fixture.angular_momentum() - angular).norm() / angular.norm();
  std::cout << "at " << fixture.stage->view().clock().time << " s: ";
  std::cout << "change of angular momentum " << change << std::endl;
  // As exact as the mass matrix is solved.
  EXPECT_LT(change, 1e-10);
}

// Velocities that change from particle to particle, of a block without stress:
// in a step a share of PIC takes as large a share of what the nodes don't see,
// and nothing of the block's motion.
TEST_P(SolidMotion, PicTakesWhatNodesDontSee)
{
  constexpr double share = 0.2;
  Box              box;
  box.cell_type = GetParam();
  box.n         = {{6, 6, 6}};
  box.is_filled = [](const Point<3> &p) {
    return (p - Point<3>(0.5, 0.5, 0.5)).norm() < 0.3;
  };
  fixture.gravity                          = Tensor<1, 3>();
  fixture.parameters.consistent_mass_share = 1.;
  fixture.parameters.pic_share             = share;
  fixture.set_time_step(1e-9);
  fixture.start(box.mesh());
  const auto motion = [](const Point<3> &position) {
    return Tensor<1, 3>({0.2, 0.1, -0.1}) +
           cross_product_3d(Tensor<1, 3>({0.3, -0.5, 0.4}), position);
  };
  const auto velocity_of = [](const auto &state) {
    Tensor<1, 3> velocity;
    for (unsigned int d = 0; d < 3; ++d)
      velocity[d] = state[Layout::velocity + d];
    return velocity;
  };
  const auto unseen = [&]() {
    double sum = 0.;
    fixture.for_each_particle([&](auto, const auto &position, auto state) {
      sum += (velocity_of(state) - motion(position)).norm_square();
    });
    return std::sqrt(sum);
  };

  for (const bool is_noisy : {false, true})
    {
      std::mt19937                     random = random_engine();
      std::normal_distribution<double> noise;
      fixture.change_particles([&](auto, const auto &position, auto state) {
        for (unsigned int d = 0; d < 3; ++d)
          state[Layout::velocity + d] =
            motion(position)[d] + (is_noisy ? noise(random) : 0.);
      });
      const double           before   = unseen();
      const Tensor<1, 3>     momentum = fixture.momentum();
      constexpr unsigned int n_steps  = 20;
      for (unsigned int step = 0; step < n_steps; ++step)
        fixture.stage->step();
      EXPECT_LT((fixture.momentum() - momentum).norm() / momentum.norm(), 1e-9);
      if (is_noisy)
        {
          // What is left is what the nodes see: they are fewer.
          EXPECT_LT(unseen(), 0.7 * before);
          EXPECT_GT(unseen(), std::pow(1. - share, n_steps) * before);
        }
      else
        {
          EXPECT_LT(unseen(), 1e-6);
        }
    }
}

// On a floor that is tilted in a direction askew to the grid.
TEST_P(SolidMotion, BlockSlidesDownASkewInclineByCoulombsLaw)
{
  const double angle = 35. * degree, direction = 30. * degree;
  Box          box;
  box.cell_type = GetParam();
  box.upper     = Point<3>(4., 0.3, 4.);
  box.n         = {{40, 3, 40}};
  box.is_filled = [](const Point<3> &p) {
    return p[0] < 1. && p[2] < 1. && p[0] > 0.3 && p[2] > 0.3 && p[1] < 0.2;
  };
  fixture.gravity = g * Tensor<1, 3>({std::sin(angle) * std::cos(direction),
                                      -std::cos(angle),
                                      std::sin(angle) * std::sin(direction)});
  fixture.walls.friction_angle   = 20.;
  fixture.material.cohesion      = 1e4; // so that it stays a block
  fixture.material.young_modulus = 1e6;
  fixture.start(box.mesh());

  run_until(0.1);
  const Tensor<1, 3> early      = mean_velocity();
  const double       early_time = fixture.stage->view().clock().time;
  run_until(0.5);
  const Tensor<1, 3> late      = mean_velocity();
  const double       late_time = fixture.stage->view().clock().time;

  const double expected =
    g * (std::sin(angle) - std::tan(20. * degree) * std::cos(angle));
  const Tensor<1, 3> measured = (late - early) / (late_time - early_time);
  std::cout << "acceleration / expected "
            << std::hypot(measured[0], measured[2]) / expected
            << ", direction in degrees "
            << std::atan2(measured[2], measured[0]) / degree << std::endl;
  EXPECT_NEAR(std::hypot(measured[0], measured[2]) / expected, 1., 0.015);
  EXPECT_NEAR(std::atan2(measured[2], measured[0]) / degree, 30., 0.5);
}

// Along the edge between two walls both rub.
TEST_P(SolidMotion, BarSlidesAlongAnEdgeByTheFrictionOfBothWalls)
{
  Box box;
  box.cell_type = GetParam();
  box.upper     = Point<3>(3., 0.2, 0.2);
  box.n         = {{60, 4, 4}};
  box.is_filled = [](const Point<3> &p) {
    return p[0] > 0.2 && p[0] < 0.6 && p[1] < 0.1 && p[2] < 0.1;
  };
  const double mu                 = std::tan(15. * degree);
  fixture.gravity                 = g * Tensor<1, 3>({std::sin(0.8),
                                                      -std::cos(0.8) * std::sqrt(0.5),
                                                      -std::cos(0.8) * std::sqrt(0.5)});
  fixture.walls.friction_angle    = 15.;
  fixture.walls.fix_bottom_corner = false; // the edge, or it would hold the bar
  fixture.material.cohesion       = 1e4;
  fixture.material.young_modulus  = 1e6;
  fixture.start(box.mesh());
  run_until(0.1);
  const double early      = mean_velocity()[0];
  const double early_time = fixture.stage->view().clock().time;
  run_until(0.4);
  const double late      = mean_velocity()[0];
  const double late_time = fixture.stage->view().clock().time;

  const double expected =
    g * (std::sin(0.8) - mu * std::cos(0.8) * std::sqrt(2.));
  const double measured = (late - early) / (late_time - early_time);
  std::cout << "acceleration / expected " << measured / expected << std::endl;
  EXPECT_NEAR(measured / expected, 1., 0.02);
}
