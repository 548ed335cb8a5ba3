#include "physics/wall_balance.h"

#include <cmath>
#include <iostream>

using namespace Sandglass;

namespace
{
  class WallBalance : public BeginningFlow
  {
  protected:
    /// In N s, summed over steps.
    struct Impulses
    {
      Tensor<1, 2> walls, momentum;
      double       weight     = 0.;
      unsigned int n_steps    = 0;
      unsigned int n_left_out = 0;
    };

    /// All steps but those in which particles leave the grid, since the totals
    /// don't tell what momentum they take along: beside a free lip single ones
    /// pass the fall region's side.
    Impulses
    add_up_steps(const double duration)
    {
      auto        &stage = *fixture.stage;
      Impulses     sum;
      const double end = stage.view().clock().time + duration;
      while (stage.view().clock().time < end)
        {
          const FlowTotals   before  = stage.view().totals();
          const Tensor<1, 2> of_axis = stage.wall_contact().axis_impulse();
          stage.step();
          const FlowTotals after  = stage.view().totals();
          const auto       forces = fixture.take_mean_forces();
          ++sum.n_steps;
          if (after.mass_removed != before.mass_removed)
            {
              ++sum.n_left_out;
              continue;
            }
          const double time_step = stage.view().clock().time_step;
          for (const MeanWallForce &force : forces)
            sum.walls += time_step * force.force;
          sum.walls += stage.wall_contact().axis_impulse() - of_axis;
          const double mass = mass_of_all(before) - before.mass_removed;
          sum.weight += time_step * mass * 9.81;
          for (unsigned int d = 0; d < 2; ++d)
            sum.momentum[d] += after.momentum[d] - before.momentum[d];
        }
      return sum;
    }
  };
} // namespace



// The forces are recorded as impulses, and step 6 gives the particles just the
// momentum that the nodes get: impulse of the walls and weight make up the
// change of momentum to rounding.
TEST_P(WallBalance, ForcesWeightAndMomentumBalance)
{
  const Impulses sum    = add_up_steps(0.1);
  const double   weight = sum.weight;
  std::cout << "walls' share of the weight " << sum.walls[1] / weight
            << ", error of the balance "
            << (sum.walls[1] - weight - sum.momentum[1]) / weight << std::endl;
  EXPECT_GT(std::abs(sum.momentum[1] / weight), 1e-3)
    << "the balance is not that of a silo at rest";
  EXPECT_NEAR((sum.walls[1] - sum.momentum[1]) / weight, 1., 1e-10);
  // In a ring, hoop stress acts along the radius too.
  if (fixture.formulation == Formulation::plane_strain)
    {
      EXPECT_NEAR((sum.walls[0] - sum.momentum[0]) / weight, 0., 1e-10);
    }
  EXPECT_LT(sum.n_left_out, sum.n_steps / 5);
}

SANDGLASS_FOR_BEGINNING_FLOWS(WallBalance);
