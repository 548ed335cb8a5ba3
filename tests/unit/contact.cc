#include <deal.II/base/numbers.h>

#include <sandglass/flow/particle_in_cell/contact.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

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
    start_at(const Point<2> &position, const Mesh<2> &mesh = Rectangle().mesh())
    {
      fixture.walls.fix_bottom_corner = false;
      fixture.start(mesh);
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
      sums->at(node)[NodalSum<2>::mass] = mass;
      for (unsigned int d = 0; d < 2; ++d)
        {
          sums->at(node)[NodalSum<2>::momentum + d] = mass * velocity[d];
          acceleration->at(node)[d]                 = 0.;
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

    /// Impulse of a wall at the only node with mass, in N s.
    Velocity
    impulse_of(const std::string &wall) const
    {
      Velocity sum;
      for (const WallRecord &record : contact->records().records)
        if (fixture.scene->walls[record.wall].name == wall)
          for (unsigned int d = 0; d < 2; ++d)
            sum[d] += record.impulse[d];
      return sum;
    }

    StageFixture                fixture;
    std::unique_ptr<Contact<2>> contact;

  private:
    using Sums  = NodalSumField<2>;
    using Field = NodalField<2>;

    std::unique_ptr<Sums>  sums;
    std::unique_ptr<Field> acceleration, mapped;
    unsigned int           node = 0;
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



namespace
{
  /// The upper three quarters of the wall at x = 1 are a wall of their own.
  Mesh<2>
  mesh_with_lining()
  {
    Mesh<2> mesh     = Rectangle().mesh();
    mesh.named_walls = {"lining"};
    for (auto &face : mesh.faces)
      if (face.role == BoundaryRole::wall &&
          mesh.vertices[face.vertices[0]][1] > 0.2)
        face.named_wall = 0;
    return mesh;
  }
} // namespace



// Where two walls meet in one plane they share the normal impulse 2 * 0.5 N s
// by area, here halves, and the friction by area times coefficient.
TEST_F(ContactTest, TwoWallsInAPlaneShareByAreaAndFriction)
{
  fixture.walls.friction_angle  = 20.;
  fixture.walls.friction_angles = {{"lining", {10.}}};
  start_at({1., 0.25}, mesh_with_lining());
  const double mu        = std::tan(20. * numbers::PI / 180.);
  const double mu_lining = std::tan(10. * numbers::PI / 180.);
  const double mean      = (mu + mu_lining) / 2.;
  expect_equal(end_velocity(Velocity({0.5, -2.})),
               Velocity({0., -2. + 0.5 * mean}));
  expect_equal(impulse_of("wall"), Velocity({-0.5, 0.5 * mu}));
  expect_equal(impulse_of("lining"), Velocity({-0.5, 0.5 * mu_lining}));
  expect_equal(impulse_of("floor"), Velocity());
}



// A corner's impulse is shared along the normals.
TEST_F(ContactTest, InACornerEachWallHasItsNormalsShare)
{
  start_at({1., 0.});
  end_velocity(Velocity({0.5, -0.3}));
  expect_equal(impulse_of("wall"), Velocity({-0.5 * mass, 0.}));
  expect_equal(impulse_of("floor"), Velocity({0., 0.3 * mass}));
}



// With 20 degrees of friction at wall and floor a velocity into the corner
// stops although one of the normals alone would let it slide off; one that is
// further away from the corner slides.
TEST_F(ContactTest, InACornerFrictionHelpsBothWallsToHold)
{
  start_at({1., 0.});
  expect_equal(end_velocity(Velocity({-0.1, -0.3})), Velocity());
  expect_equal(end_velocity(Velocity({0.3, 0.1})), Velocity());
  const double mu = std::tan(20. * numbers::PI / 180.);
  expect_equal(end_velocity(Velocity({-0.2, -0.3})),
               Velocity({-0.2 + 0.3 * mu, 0.}));
  EXPECT_NEAR(contact->friction_dissipation(),
              mass * 0.3 * mu * (0.2 - 0.3 * mu),
              1e-15);
}



// Sliding over a floor that is faster, material is pulled along; the wall's
// work is its force times its own velocity.
TEST_F(ContactTest, FrictionFollowsTheVelocityRelativeToTheWalls)
{
  fixture.walls.velocities = {{"floor", {3., 0.}}};
  start_at({0.5, 0.});
  const double impulse = std::tan(20. * numbers::PI / 180.) * 0.3 * mass;
  const double end     = 1. + impulse / mass;
  expect_equal(end_velocity(Velocity({1., -0.3})), Velocity({end, 0.}));
  EXPECT_NEAR(contact->wall_work(), impulse * 3., 1e-14);
  EXPECT_NEAR(contact->friction_dissipation() + contact->friction_energy(),
              impulse * (3. - end),
              1e-14);
  // The same velocity as the wall's, nothing being stretched: no friction.
  start_at({0.5, 0.});
  expect_equal(end_velocity(Velocity({3., -0.3})), Velocity({3., 0.}));
}
