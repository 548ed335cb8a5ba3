// Motion by finite elements with re-zoning, against closed forms.

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "../updated_lagrangian_fixture.h"

using namespace Sandglass;

namespace
{
  /// A block on a floor that reaches far to its right.
  Mesh<2>
  block_on_floor()
  {
    Rectangle rectangle;
    rectangle.upper     = Point<2>(6., 1.);
    rectangle.n_x       = 18;
    rectangle.n_y       = 3;
    rectangle.left      = BoundaryRole::wall;
    rectangle.is_filled = [](const Point<2> &p) {
      return p[0] > 1. && p[0] < 2.;
    };
    Mesh<2> mesh = rectangle.mesh();
    // The block's sides are free, too.
    for (const unsigned int i : {3u, 6u})
      for (unsigned int j = 0; j < 3; ++j)
        mesh.faces.push_back(
          {{{19 * j + i, 19 * (j + 1) + i}}, BoundaryRole::top});
    return mesh;
  }

  /// On a floor that is inclined so many degrees; gravity is turned instead.
  struct Incline : UpdatedLagrangianFixture
  {
    explicit Incline(const double degrees)
    {
      const double angle = degrees * numbers::PI / 180.;
      gravity = Tensor<1, 2>({9.81 * std::sin(angle), -9.81 * std::cos(angle)});
      walls.friction_angle   = 20.;
      material.cohesion      = 1e7;
      material.young_modulus = 1e7;
      start(block_on_floor());
    }
  };
} // namespace



// Without walls material falls freely, also through re-zonings.
TEST(UpdatedLagrangianMotion, FreeFall)
{
  for (const unsigned int order : {1u, 2u})
    {
      UpdatedLagrangianFixture fixture;
      fixture.parameters.element_order = order;
      Rectangle rectangle;
      rectangle.lower = Point<2>(0., -1.);
      rectangle.n_y   = 8;
      rectangle.left = rectangle.right = BoundaryRole::top;
      rectangle.bottom                 = BoundaryRole::top;
      rectangle.is_filled = [](const Point<2> &p) { return p[1] > 0.; };
      fixture.start(rectangle.mesh());
      const double mass = fixture.flow->view().totals().mass_in_silo;
      for (unsigned int i = 0; i < 20; ++i)
        {
          fixture.flow->step();
          if (i % 5 == 4)
            fixture.flow->rezone("test");
        }
      const double t = fixture.flow->view().clock().time;
      EXPECT_NEAR(t, 0.2, 1e-12);
      const auto totals = fixture.flow->view().totals();
      EXPECT_NEAR((totals.mass_in_silo + totals.mass_falling) / mass,
                  1.,
                  1e-12);
      fixture.flow->view().for_each_particle([&](const auto &particle) {
        EXPECT_NEAR(particle.velocity[0], 0., 1e-7);
        EXPECT_NEAR(particle.velocity[1], -9.81 * t, 1e-7);
        EXPECT_NEAR(particle.location[1] - particle.initial_location[1],
                    -9.81 * t * t / 2.,
                    1e-7);
      });
    }
}



// Below the wall friction angle of 20 degrees a block stays where it is, and
// above it accelerates by g (sin theta - tan(20 degrees) cos theta).
TEST(UpdatedLagrangianMotion, BlockOnAnIncline)
{
  Incline flat(15.);
  flat.rest();
  for (unsigned int i = 0; i < 30; ++i)
    flat.flow->step();
  // It swings a little about its foot.
  EXPECT_LT(flat.mean_velocity().norm(), 5e-3);

  // It starts without stress, so it first bounces.
  Incline    steep(30.);
  const auto run = [&steep](const double time) {
    unsigned int i = 0;
    for (; steep.flow->view().clock().time < time; ++i)
      {
        steep.flow->step();
        if (i % 10 == 9)
          steep.flow->rezone("test");
      }
    return std::make_pair(steep.flow->view().clock().time,
                          steep.mean_velocity()[0]);
  };
  const auto [time_before, before] = run(0.2);
  const auto [time_after, after]   = run(0.6);
  const double angle               = 30. * numbers::PI / 180.;
  const double expected =
    9.81 *
    (std::sin(angle) - std::tan(20. * numbers::PI / 180.) * std::cos(angle));
  const double acceleration = (after - before) / (time_after - time_before);
  std::cout << "acceleration " << acceleration << ", expected " << expected
            << std::endl;
  EXPECT_NEAR(acceleration / expected, 1., 0.02);
}



// Material at rest between rough walls keeps their forces through fifty
// re-zonings, and stays where it is. What changes comes with the first meshes,
// which differ from that of the state at rest.
TEST(UpdatedLagrangianMotion, ColumnAtRestThroughFiftyRezonings)
{
  UpdatedLagrangianFixture column;
  column.walls.friction_angle = 20.;
  Rectangle rectangle;
  rectangle.upper = Point<2>(0.5, 2.);
  rectangle.n_x   = 7;
  rectangle.n_y   = 28;
  column.start(rectangle.mesh());
  column.rest();
  column.flow->step();
  const Tensor<1, 2> right({1., 0.});
  const Tensor<1, 2> before = column.wall_force(right);
  const double       mass   = column.flow->view().totals().mass_in_silo;
  for (unsigned int i = 0; i < 50; ++i)
    {
      column.flow->rezone("test");
      column.flow->step();
      if (i % 10 == 0)
        std::cout << "wall force " << column.wall_force(right) << " N/m"
                  << std::endl;
    }
  const Tensor<1, 2> after = column.wall_force(right);
  std::cout << "wall force " << before << " N/m, then " << after
            << " N/m; weight " << 9.81 * mass << " N/m" << std::endl;
  EXPECT_GT(before[1], 0.1 * 9.81 * mass);
  EXPECT_NEAR(after[0] / before[0], 1., 0.01);
  EXPECT_NEAR(after[1] / before[1], 1., 0.01);
  const auto totals = column.flow->view().totals();
  EXPECT_NEAR(totals.mass_in_silo / mass, 1., 1e-12);
  EXPECT_LT(totals.largest_speed, 1e-2);
}



// What load() goes on from is bit by bit what save() has written, also across
// a re-zoning.
TEST(UpdatedLagrangianMotion, GoesOnFromACheckpoint)
{
  Incline incline(30.);
  for (unsigned int i = 0; i < 5; ++i)
    incline.flow->step();
  incline.flow->rezone("test");
  incline.flow->step();
  std::stringstream stream;
  {
    boost::archive::binary_oarchive archive(stream);
    incline.flow->save(archive);
  }
  const auto                      other = incline.make();
  boost::archive::binary_iarchive archive(stream);
  other->load(archive);
  for (unsigned int i = 0; i < 3; ++i)
    {
      incline.flow->step();
      other->step();
      if (i == 1)
        {
          incline.flow->rezone("test");
          other->rezone("test");
        }
    }
  const auto a = incline.flow->view().totals(), b = other->view().totals();
  EXPECT_GT(a.kinetic_energy, 0.);
  EXPECT_EQ(a.kinetic_energy, b.kinetic_energy);
  EXPECT_EQ(a.elastic_energy, b.elastic_energy);
  EXPECT_EQ(a.dissipated_energy, b.dissipated_energy);
  EXPECT_EQ(incline.flow->view().clock().time, other->view().clock().time);
  EXPECT_EQ(incline.flow->n_rezonings(), other->n_rezonings());
}
