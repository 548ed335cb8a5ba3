#include <sandglass/walls/corner.h>

#include <gtest/gtest.h>

#include <cmath>

#include "random_engine.h"

using namespace Sandglass;

namespace
{
  template <int dim>
  Support<dim>
  support(const Tensor<1, dim> &direction, const bool is_axis = false)
  {
    Support<dim> result;
    result.normal  = direction / direction.norm();
    result.is_axis = is_axis;
    return result;
  }

  template <int dim>
  Tensor<1, dim>
  held(const Supports<dim> &supports, const Tensor<1, dim> &velocity)
  {
    return HeldDirections<dim>(supports,
                               holding_supports<dim>(supports, velocity))
      .left_of(velocity);
  }
} // namespace

// A wall at the right, x = 1, and a floor.
TEST(Corner, EachWallHoldsWhatTheOtherLetsPass)
{
  const Supports<2> corner{support(Tensor<1, 2>({1., 0.})),
                           support(Tensor<1, 2>({0., -1.}))};
  const auto        set = [&corner](const double x, const double y) {
    return holding_supports<2>(corner, Tensor<1, 2>({x, y}));
  };
  EXPECT_EQ(set(-1., 1.), 0u);
  EXPECT_EQ(set(1., 1.), 1u);
  EXPECT_EQ(set(-1., -1.), 2u);
  EXPECT_EQ(set(1., -1.), 3u);
}

// Between two walls at an obtuse angle, material that one of them stops may
// still run into the other one, or slide off along it.
TEST(Corner, AnObtuseCornerHoldsByOneWallWhereThatIsEnough)
{
  const Supports<2> corner{support(Tensor<1, 2>({1., 0.})),
                           support(Tensor<1, 2>({1., -1.}))};
  // Straight down along the wall: the inclined one alone.
  EXPECT_EQ(holding_supports<2>(corner, Tensor<1, 2>({0., -1.})), 2u);
  // What the wall stops slides up and off the inclined one.
  EXPECT_EQ(holding_supports<2>(corner, Tensor<1, 2>({1., 0.5})), 1u);
  // Stopped by either, it would run into the other.
  EXPECT_EQ(holding_supports<2>(corner, Tensor<1, 2>({1., -0.5})), 3u);
}

TEST(Corner, TheAxisHoldsBothWays)
{
  const Supports<2> node{support(Tensor<1, 2>({-1., 0.}), true),
                         support(Tensor<1, 2>({0., -1.}))};
  EXPECT_EQ(holding_supports<2>(node, Tensor<1, 2>({1., 1.})), 1u);
  EXPECT_EQ(holding_supports<2>(node, Tensor<1, 2>({-1., 1.})), 1u);
  EXPECT_EQ(holding_supports<2>(node, Tensor<1, 2>({1., -1.})), 3u);
}

TEST(Corner, SharesAlongTheNormalsMakeUpTheForce)
{
  const Supports<2>  corner{support(Tensor<1, 2>({1., 0.2})),
                           support(Tensor<1, 2>({0.9, -1.}))};
  const Tensor<1, 2> force({-3., 0.7});
  const auto         shares = HeldDirections<2>(corner, 3u).split(force);
  EXPECT_NEAR((shares[0] * corner[0].normal + shares[1] * corner[1].normal -
               force)
                .norm(),
              0.,
              1e-14);
  const auto of_one = HeldDirections<2>(corner, 2u).split(force);
  EXPECT_EQ(of_one[0], 0.);
  EXPECT_NEAR(of_one[1], force * corner[1].normal, 1e-14);
}

// In any corner of two or three dimensions: no wall is entered, none that
// holds has to pull, and what is left is nearest to the velocity.
template <int dim>
void
expect_projection(const unsigned int n_supports_of_node)
{
  auto                             engine = random_engine();
  std::normal_distribution<double> number;
  const auto                       random_vector = [&]() {
    Tensor<1, dim> vector;
    for (unsigned int d = 0; d < dim; ++d)
      vector[d] = number(engine);
    return vector;
  };
  for (unsigned int i = 0; i < 1000; ++i)
    {
      Supports<dim> supports;
      for (unsigned int s = 0; s < n_supports_of_node; ++s)
        supports.push_back(support<dim>(random_vector()));
      const Tensor<1, dim>      velocity = random_vector();
      const SupportSet          set = holding_supports<dim>(supports, velocity);
      const HeldDirections<dim> directions(supports, set);
      const Tensor<1, dim>      left     = directions.left_of(velocity);
      const auto                pressure = directions.split(velocity);
      Tensor<1, dim>            sum      = left;
      for (unsigned int s = 0; s < supports.size(); ++s)
        {
          EXPECT_LT(left * supports[s].normal, 1e-8);
          EXPECT_GT(pressure[s], -1e-8);
          sum += pressure[s] * supports[s].normal;
        }
      EXPECT_NEAR((sum - velocity).norm(), 0., 1e-6);
    }
}

TEST(Corner, WhatIsLeftIsTheNearestVelocityThatNoWallStops)
{
  expect_projection<2>(1);
  expect_projection<2>(2);
  expect_projection<3>(2);
  expect_projection<3>(3);
}
