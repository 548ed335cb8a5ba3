#include <gtest/gtest.h>

#include "all_settings.h"
#include "benchmark/loop_difference.h"

using namespace Sandglass;

namespace
{
  template <typename Setting>
  class PlainLoopTest : public testing::Test
  {};

  TYPED_TEST_SUITE(PlainLoopTest, AllSettings);
} // namespace



// The loop against Section 4.4 as one writes it first, particle by particle:
// blocks, lanes, sums left by the last pass and particles that change cell make
// no difference but rounding.
TYPED_TEST(PlainLoopTest, AgreesWithTheStage)
{
  FlowingSilo<TypeParam> silo(1);
  PlainLoop<TypeParam>   plain(*silo.scene,
                             silo.material,
                             silo.walls,
                             silo.stage->particles().handler());
  for (unsigned int n = 0; n < 200; ++n)
    {
      silo.stage->step();
      plain.step(silo.stage->view().clock().time_step);
    }
  EXPECT_LT(loop_difference(silo, plain), 1e-9);
}



// The sums over particles that the pass, changes of cell and, in axisymmetric
// silos, splitting leave for the next step are those that all particles would
// give anew.
TYPED_TEST(PlainLoopTest, SumsAreKeptUpToDate)
{
  using Silo = FlowingSilo<TypeParam>;
  Silo kept(1, Silo::Method::program), anew(1, Silo::Method::program);
  for (unsigned int n = 0; n < 200; ++n)
    {
      kept.stage->step();
      anew.stage->edit_blocks([](auto &) {});
      anew.stage->step();
    }
  const double energy = kinetic_energy(anew.stage->particles().handler());
  EXPECT_NEAR(kinetic_energy(kept.stage->particles().handler()) / energy,
              1.,
              1e-10);
}
