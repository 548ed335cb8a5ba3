#include <sandglass/flow/particle_in_cell/contact.h>

#include <gtest/gtest.h>

#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  constexpr double mass = 2., time_step = 0.01;

  using Velocity = Tensor<1, 2>;

  /// Contact at one node of a unit square: axis at x = 0, wall at x = 1, floor
  /// at y = 0.
  class ContactTest : public testing::Test
  {
  protected:
    void
    start_at(const Point<2> &position)
    {
      fixture.walls.fix_bottom_corner = false;
      fixture.start(Rectangle().mesh());
      contact = std::make_unique<Contact<2>>(*fixture.scene, fixture.walls);
      sums    = std::make_unique<Sums>(*fixture.scene->nodes);
      acceleration = std::make_unique<Field>(*fixture.scene->nodes);
      mapped       = std::make_unique<Field>(*fixture.scene->nodes);

      fixture.for_each_node(
        [&](const Point<2> &vertex, const unsigned int index) {
          if (vertex.distance(position) < 1e-12)
            node = index;
        });
    }

    /// Velocity at the end of a step in which no other force acts.
    Velocity
    end_velocity(const Velocity &velocity)
    {
      sums->at(node)[NodalSum::mass] = mass;
      for (unsigned int d = 0; d < 2; ++d)
        {
          sums->at(node)[NodalSum::momentum + d] = mass * velocity[d];
          acceleration->at(node)[d]              = 0.;
        }
      contact->apply(*sums, time_step, *acceleration);
      const double *change = acceleration->at(node);
      return velocity + time_step * Velocity({change[0], change[1]});
    }

    /// What is left of v^L.
    Velocity
    constrained(const Velocity &velocity)
    {
      for (unsigned int d = 0; d < 2; ++d)
        mapped->at(node)[d] = velocity[d];
      contact->constrain(*mapped);
      return Velocity({mapped->at(node)[0], mapped->at(node)[1]});
    }

    static void
    expect_equal(const Velocity &velocity, const Velocity &expected)
    {
      EXPECT_NEAR((velocity - expected).norm(), 0., 1e-15)
        << velocity << " instead of " << expected;
    }

    StageFixture fixture;

  private:
    using Sums  = NodalField<NodalSum::n_components>;
    using Field = NodalField<dim>;

    std::unique_ptr<Contact<2>> contact;
    std::unique_ptr<Sums>       sums;
    std::unique_ptr<Field>      acceleration, mapped;
    unsigned int                node = 0;
  };
} // namespace



// The wall that presses holds v^L both ways; friction leaves it alone.
TEST_F(ContactTest, APressedNodeKeepsNoNormalVelocity)
{
  start_at({1., 0.5});
  EXPECT_NEAR(end_velocity(Velocity({0.5, 0.3}))[0], 0., 1e-16);
  expect_equal(constrained(Velocity({-0.7, 0.3})), Velocity({0., 0.3}));
  expect_equal(constrained(Velocity({0.7, -0.3})), Velocity({0., -0.3}));
}



TEST_F(ContactTest, ASeparatingNodeIsOnlyKeptFromEnteringTheWall)
{
  start_at({1., 0.5});
  expect_equal(end_velocity(Velocity({-0.5, 0.3})), Velocity({-0.5, 0.3}));
  expect_equal(constrained(Velocity({-0.7, 0.3})), Velocity({-0.7, 0.3}));
  expect_equal(constrained(Velocity({0.7, 0.3})), Velocity({0., 0.3}));
}



// Which supports held it is decided anew in each step.
TEST_F(ContactTest, ANodeThatWasPressedMaySeparate)
{
  start_at({1., 0.5});
  end_velocity(Velocity({0.5, 0.3}));
  end_velocity(Velocity({-0.5, 0.3}));
  expect_equal(constrained(Velocity({-0.7, 0.3})), Velocity({-0.7, 0.3}));
}



// The mirror image cancels the momentum across the axis: no force has to.
TEST_F(ContactTest, TheAxisHoldsBothWaysWithoutFriction)
{
  start_at({0., 0.5});
  for (const double radial : {-0.5, 0.5})
    {
      expect_equal(end_velocity(Velocity({radial, 0.3})),
                   Velocity({radial, 0.3}));
      expect_equal(constrained(Velocity({radial, 0.3})), Velocity({0., 0.3}));
    }
}



TEST_F(ContactTest, InACornerBothWallsHold)
{
  start_at({1., 0.});
  expect_equal(end_velocity(Velocity({0.5, -0.3})), Velocity());
  expect_equal(constrained(Velocity({-0.7, 0.3})), Velocity());
}



// The floor presses, the wall doesn't: v^L stays on the floor, but not even its
// noise may enter the wall.
TEST_F(ContactTest, InACornerOneWallThatPressesDoesNotOpenTheOther)
{
  start_at({1., 0.});
  EXPECT_NEAR(end_velocity(Velocity({-0.5, -0.3}))[1], 0., 1e-16);
  expect_equal(constrained(Velocity({-0.7, 0.2})), Velocity({-0.7, 0.}));
  expect_equal(constrained(Velocity({0.7, 0.2})), Velocity());
}
