#include <sandglass/walls/friction.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace Sandglass;

namespace
{
  // mu N = 3 N; c_T A dt = 0.5 N s / m
  const CoulombFriction
    return_mapping(0.3, 1e3, 0., FrictionUpdate::return_mapping);
  const CoulombFriction
                   velocity_sign(0.3, 1e3, 0., FrictionUpdate::velocity_sign);
  constexpr double normal_force = 10., mass = 2., area = 0.05, time_step = 0.01;

  double
  force(const CoulombFriction &friction,
        FrictionMemory        &memory,
        const double           velocity,
        const double           free_velocity)
  {
    return friction.tangential_force(
      memory, normal_force, velocity, free_velocity, mass, area, time_step);
  }
} // namespace

TEST(Friction, StickingForceSolvesThePenaltyLawAtTheEndOfTheStep)
{
  FrictionMemory memory{0.7, false};
  const double   result       = force(return_mapping, memory, 0.1, 0.2);
  const double   end_velocity = 0.2 + time_step * result / mass;
  EXPECT_NEAR(result, 0.7 - 1e3 * area * end_velocity * time_step, 1e-14);
  EXPECT_FALSE(memory.is_sliding);
  EXPECT_EQ(memory.tangential_force, result);
}

TEST(Friction, SlidesWhereThePenaltyForceExceedsTheLimit)
{
  FrictionMemory memory{-2.9, false};
  EXPECT_DOUBLE_EQ(force(return_mapping, memory, 1., 1.), -3.);
  EXPECT_TRUE(memory.is_sliding);
}

TEST(Friction, SlidingGoesOnWhileTheDirectionStays)
{
  FrictionMemory memory{-3., true};
  EXPECT_DOUBLE_EQ(force(return_mapping, memory, 1., 0.5), -3.);
  EXPECT_TRUE(memory.is_sliding);
}

TEST(Friction, StopsRatherThanTurnsBack)
{
  // Sliding friction would turn the node's velocity to -0.005 m/s.
  FrictionMemory memory{-3., true};
  const double   result       = force(velocity_sign, memory, 0.02, 0.01);
  const double   end_velocity = 0.01 + time_step * result / mass;
  EXPECT_LE(std::abs(result), 3.);
  EXPECT_FALSE(memory.is_sliding);
  EXPECT_NEAR(result, -3. - 1e3 * area * end_velocity * time_step, 1e-14);
}

// A node that slid down and moves up by next to nothing: its friction goes on
// from where it was, by the paper's rule it turns round.
TEST(Friction, IsContinuousWhereTheVelocityTurns)
{
  FrictionMemory memory{3., true};
  EXPECT_NEAR(force(return_mapping, memory, 1e-9, 1e-9), 3., 0.01);
  memory = {3., true};
  EXPECT_NEAR(force(velocity_sign, memory, 1e-9, 1e-9), -3., 0.01);
}

// c_T A dt^2 / m is 2.5e-3, so a limit of 1e-3 takes c_T down to 400 N/m^3, and
// one of 3e-3 leaves it.
TEST(Friction, APenaltyAboveItsLimitActsLikeALowerOne)
{
  const auto result = [](const double penalty, const double limit) {
    const CoulombFriction friction(0.3,
                                   penalty,
                                   limit,
                                   FrictionUpdate::return_mapping);
    FrictionMemory        memory{0.7, false};
    force(friction, memory, 0.1, 0.2);
    friction.stretch(memory, 0.3, area, time_step);
    return memory.tangential_force;
  };
  EXPECT_DOUBLE_EQ(result(1e3, 1e-3), result(400., 0.));
  EXPECT_EQ(result(1e3, 3e-3), result(1e3, 0.));
  EXPECT_GT(std::abs(result(1e3, 0.) - result(400., 0.)), 1e-3);
}

// The limit takes the stiffness to 10 mass N / (kg m), so a node that loses
// three quarters of its mass keeps half of its force. A step of half the length
// changes nothing: what sticks at rest needs its force.
TEST(Friction, ALimitedSpringKeepsItsEnergyWhenItsNodeLosesMass)
{
  const CoulombFriction limited(0.3, 1e6, 1e-3, FrictionUpdate::return_mapping);
  FrictionMemory        memory{2., false};
  const auto            rest = [&](const double node_mass, const double step) {
    return limited.tangential_force(
      memory, normal_force, 0., 0., node_mass, area, step);
  };
  // The spring itself slows the node by a thousandth in each step.
  EXPECT_DOUBLE_EQ(rest(mass, time_step), 2. / 1.001);
  EXPECT_DOUBLE_EQ(rest(mass / 4., time_step), 1. / std::pow(1.001, 2));
  EXPECT_DOUBLE_EQ(rest(mass / 4., time_step / 2.), 1. / std::pow(1.001, 3));
}

TEST(Friction, VanishesWithoutNormalForce)
{
  FrictionMemory memory{-1., false};
  EXPECT_EQ(
    return_mapping.tangential_force(memory, 0., 1., 1., mass, area, time_step),
    0.);
}
