#include <sandglass/walls/friction.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "random_engine.h"

using namespace Sandglass;

namespace
{
  using Friction2 = PenaltyFriction<2>;
  using Memory    = FrictionMemory<2>;
  using Force     = Tensor<1, 2>;

  // The limit mu N is 3 N; c_T A dt = 0.5 N s / m
  const Friction2  return_mapping(1e3, 0., FrictionUpdate::return_mapping);
  const Friction2  velocity_sign(1e3, 0., FrictionUpdate::velocity_sign);
  constexpr double limit = 3., mass = 2., area = 0.05, time_step = 0.01;

  /// Along the wall.
  Force
  along(const double value)
  {
    return Force({0.6 * value, 0.8 * value});
  }

  /// Along the wall, positive if so; nothing may point off it.
  double
  force(const Friction2 &friction,
        Memory          &memory,
        const double     velocity,
        const double     free_velocity)
  {
    const Force result = friction
                           .step(memory,
                                 limit,
                                 along(velocity),
                                 along(free_velocity),
                                 mass,
                                 area,
                                 time_step)
                           .force;
    EXPECT_NEAR((result - along(result * along(1.))).norm(), 0., 1e-15);
    EXPECT_EQ((result - memory.force).norm(), 0.);
    return result * along(1.);
  }
} // namespace

TEST(Coulomb, TheForceThatSticksAsFarAsTheLimit)
{
  const auto sticks = coulomb(Force({3., -4.}), 5.1);
  EXPECT_EQ(sticks.force, Force({3., -4.}));
  EXPECT_FALSE(sticks.is_sliding);
  const auto slides = coulomb(Force({3., -4.}), 2.);
  EXPECT_NEAR((slides.force - Force({1.2, -1.6})).norm(), 0., 1e-15);
  EXPECT_TRUE(slides.is_sliding);
  const auto smooth = coulomb(Force(), 0.);
  EXPECT_EQ(smooth.force, Force());
  EXPECT_TRUE(smooth.is_sliding);
}

TEST(Friction, StickingForceSolvesThePenaltyLawAtTheEndOfTheStep)
{
  Memory       memory{along(0.7), false};
  const double result       = force(return_mapping, memory, 0.1, 0.2);
  const double end_velocity = 0.2 + time_step * result / mass;
  EXPECT_NEAR(result, 0.7 - 1e3 * area * end_velocity * time_step, 1e-14);
  EXPECT_FALSE(memory.is_sliding);
}

TEST(Friction, SlidesWhereThePenaltyForceExceedsTheLimit)
{
  Memory memory{along(-2.9), false};
  EXPECT_NEAR(force(return_mapping, memory, 1., 1.), -3., 1e-14);
  EXPECT_TRUE(memory.is_sliding);
}

TEST(Friction, SlidingGoesOnWhileTheDirectionStays)
{
  Memory memory{along(-3.), true};
  EXPECT_NEAR(force(return_mapping, memory, 1., 0.5), -3., 1e-14);
  EXPECT_TRUE(memory.is_sliding);
}

TEST(Friction, StopsRatherThanTurnsBack)
{
  // Sliding friction would turn the node's velocity to -0.005 m/s.
  Memory       memory{along(-3.), true};
  const double result       = force(velocity_sign, memory, 0.02, 0.01);
  const double end_velocity = 0.01 + time_step * result / mass;
  EXPECT_LE(std::abs(result), 3.);
  EXPECT_FALSE(memory.is_sliding);
  EXPECT_NEAR(result, -3. - 1e3 * area * end_velocity * time_step, 1e-14);
}

// A node that slid down and moves up by next to nothing: its friction goes on
// from where it was, by the paper's rule it turns round.
TEST(Friction, IsContinuousWhereTheVelocityTurns)
{
  Memory memory{along(3.), true};
  EXPECT_NEAR(force(return_mapping, memory, 1e-9, 1e-9), 3., 0.01);
  memory = {along(3.), true};
  EXPECT_NEAR(force(velocity_sign, memory, 1e-9, 1e-9), -3., 0.01);
}

// c_T A dt^2 / m is 2.5e-3, so a limit of 1e-3 takes c_T down to 400 N/m^3, and
// one of 3e-3 leaves it.
TEST(Friction, APenaltyAboveItsLimitActsLikeALowerOne)
{
  const auto result = [](const double penalty, const double penalty_limit) {
    const Friction2 friction(penalty,
                             penalty_limit,
                             FrictionUpdate::return_mapping);
    Memory          memory{along(0.7), false};
    force(friction, memory, 0.1, 0.2);
    friction.stretch(memory, along(0.3), area, time_step);
    return memory.force * along(1.);
  };
  EXPECT_NEAR(result(1e3, 1e-3), result(400., 0.), 1e-15);
  EXPECT_EQ(result(1e3, 3e-3), result(1e3, 0.));
  EXPECT_GT(std::abs(result(1e3, 0.) - result(400., 0.)), 1e-3);
}

// The limit takes the stiffness to 10 mass N / (kg m), so a node that loses
// three quarters of its mass keeps half of its force. A step of half the length
// changes nothing: what sticks at rest needs its force.
TEST(Friction, ALimitedSpringKeepsItsEnergyWhenItsNodeLosesMass)
{
  const Friction2 limited(1e6, 1e-3, FrictionUpdate::return_mapping);
  Memory          memory{along(2.), false};
  const auto      rest = [&](const double node_mass, const double step) {
    return limited.step(memory, limit, Force(), Force(), node_mass, area, step)
             .force *
           along(1.);
  };
  // The spring itself slows the node by a thousandth in each step.
  EXPECT_NEAR(rest(mass, time_step), 2. / 1.001, 1e-14);
  EXPECT_NEAR(rest(mass / 4., time_step), 1. / std::pow(1.001, 2), 1e-14);
  EXPECT_NEAR(rest(mass / 4., time_step / 2.), 1. / std::pow(1.001, 3), 1e-14);
}

// The slip's work is what the spring keeps more and what is dissipated; the
// latter is never negative, whatever slip, mass and limit do.
TEST(Friction, DissipationNeverFallsAndClosesTheEnergyBalance)
{
  auto                                   engine = random_engine();
  std::uniform_real_distribution<double> of_one(-1., 1.);
  const Friction2 limited(1e3, 1e-3, FrictionUpdate::return_mapping);
  Memory          memory;
  bool            has_stuck = false, has_slid = false;
  for (unsigned int i = 0; i < 1000; ++i)
    {
      const double node_mass = mass * (1.2 + of_one(engine));
      const double most      = limit * (1. + of_one(engine));
      const Force  free      = along(of_one(engine));
      // The change of mass keeps the spring's energy.
      const double kept = limited.energy(memory, area, time_step);
      const auto   step =
        limited.step(memory, most, free, free, node_mass, area, time_step);
      const Force end = free + time_step / node_mass * step.force;
      EXPECT_GE(step.dissipation, 0.);
      EXPECT_NEAR(-time_step * (step.force * end),
                  limited.energy(memory, area, time_step) - kept +
                    step.dissipation,
                  1e-13);
      (memory.is_sliding ? has_slid : has_stuck) = true;
    }
  EXPECT_TRUE(has_stuck);
  EXPECT_TRUE(has_slid);
}

TEST(Friction, VanishesWithoutNormalForce)
{
  Memory memory{along(-1.), false};
  EXPECT_EQ(return_mapping
              .step(memory, 0., along(1.), along(1.), mass, area, time_step)
              .force,
            Force());
}
