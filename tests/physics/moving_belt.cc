#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "heap.h"

using namespace Sandglass;

namespace
{
  constexpr double g = 9.81, degree = numbers::PI / 180.;

  /// A heap at rest, whose floor suddenly moves like a belt.
  class Belt : public Heap
  {
  public:
    Belt(const double belt_velocity, const double friction_angle)
    {
      fixture.walls.friction_angle = friction_angle;
      fixture.walls.velocities     = {{"floor", {belt_velocity, 0.}}};
      fixture.start(rectangle.mesh());
    }

    /// What the heap has at one time, and what it has got and lost until then;
    /// in J.
    struct Energies
    {
      double stored, dissipated, wall_work;
    };

    Energies
    energies() const
    {
      const FlowTotals totals = fixture.stage->view().totals();
      return {totals.kinetic_energy + totals.elastic_energy +
                potential_energy(),
              totals.dissipated_energy,
              totals.wall_work};
    }

    /// Of the energy balance from now on, relative to the belt's work.
    double
    error_of_balance_until(const double end)
    {
      const Energies before = energies();
      run_until(end);
      const Energies after = energies();
      const double   work  = after.wall_work - before.wall_work;
      const double   error =
        (after.stored - before.stored + after.dissipated - before.dissipated) /
          work -
        1.;
      std::cout << "belt's work " << work << " J, dissipated "
                << (after.dissipated - before.dissipated) / work
                << ", error of the balance " << error << std::endl;
      return error;
    }
  };
} // namespace

// Friction alone accelerates the heap: by mu g, whatever its mass.
TEST(MovingBelt, AFastBeltAcceleratesByCoulombFriction)
{
  Belt         belt(5., 20.);
  const double early_velocity = belt.velocity_at(0.1);
  const double early          = belt.time();
  const double late_velocity  = belt.velocity_at(0.6);
  const double measured =
    (late_velocity - early_velocity) / (belt.time() - early);
  const double expected = std::tan(20. * degree) * g;
  std::cout << "acceleration / expected " << measured / expected << std::endl;
  EXPECT_NEAR(measured / expected, 1., 0.01);
}

// It gets to the belt's 0.5 m/s within 0.14 s, and stays there.
TEST(MovingBelt, ASlowBeltTakesTheHeapAlong)
{
  Belt belt(0.5, 20.);
  for (const double time : {0.4, 0.7, 1.})
    {
      const double ratio = belt.velocity_at(time) / 0.5;
      std::cout << "velocity / the belt's " << ratio << std::endl;
      EXPECT_NEAR(ratio, 1., 0.01);
    }
}

// What the belt puts in is either in the heap or lost by friction.
TEST(MovingBelt, ItsPowerClosesTheEnergyBalance)
{
  Belt fast(5., 20.);
  fast.run_until(0.1);
  EXPECT_NEAR(fast.error_of_balance_until(0.6), 0., 0.01);
  EXPECT_NEAR(fast.fixture.stage->view().totals().momentum[0] * 5.,
              fast.energies().wall_work,
              1e-9 * fast.energies().wall_work)
    << "the belt's work is its force times its velocity";
}

// A wall whose own friction is zero moves nothing.
TEST(MovingBelt, ASmoothBeltLeavesTheHeapAtRest)
{
  Belt belt(5., 0.);
  EXPECT_NEAR(belt.velocity_at(0.2), 0., 1e-12);
  EXPECT_EQ(belt.energies().wall_work, 0.);
}
