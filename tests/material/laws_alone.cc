// The laws compile and work without deal.II: this file includes nothing of it.

#include <sandglass/material/drucker_prager.h>

#include <gtest/gtest.h>

using namespace Sandglass;

#ifdef DEAL_II_VERSION_MAJOR
#  error "A law includes deal.II."
#endif

namespace
{
  struct Increment
  {
    SymmetricComponents<6> strain;
  };
} // namespace



TEST(LawsAlone, six_components_give_what_four_do)
{
  const DruckerPrager    law(Elasticity(1e6, 0.3), 0.4363);
  SymmetricComponents<4> in_plane(-1e3, -2e3, -1.5e3, 900.);
  SymmetricComponents<6> in_space;
  in_space << in_plane, 0., 0.;
  std::array<double, 0> none;

  Increment increment;
  increment.strain << 1e-3, -2e-3, 5e-4, 1e-3, 0., 0.;
  const SymmetricComponents<6> prediction          = law.predict(increment, 0.);
  const SymmetricComponents<4> prediction_in_plane = prediction.head<4>();

  const double work          = law.correct(in_space, none, prediction);
  const double work_in_plane = law.correct(in_plane, none, prediction_in_plane);
  EXPECT_GT(work, 0.);
  EXPECT_DOUBLE_EQ(work, work_in_plane);
  EXPECT_NEAR(law.yield_function(in_space),
              0.,
              1e-9 * von_mises_stress(in_space));
  for (int c = 0; c < 4; ++c)
    EXPECT_DOUBLE_EQ(in_space[c], in_plane[c]);
  EXPECT_EQ(in_space[4], 0.);
}



// A rotation of the axes (x -> y -> z) must not change what the law does.
TEST(LawsAlone, no_direction_is_special)
{
  const DruckerPrager    law(Elasticity(1e6, 0.3), 0.4363);
  SymmetricComponents<6> stress, turned;
  stress << -1e3, -2e3, -1.5e3, 900., 700., -300.; // xx yy zz xy yz xz
  turned << stress[2], stress[0], stress[1], stress[5], stress[3], stress[4];
  law.project(stress);
  law.project(turned);
  EXPECT_DOUBLE_EQ(turned[0], stress[2]);
  EXPECT_DOUBLE_EQ(turned[1], stress[0]);
  EXPECT_DOUBLE_EQ(turned[3], stress[5]);
  EXPECT_DOUBLE_EQ(turned[4], stress[3]);
  EXPECT_NEAR(law.yield_function(stress), 0., 1e-9 * von_mises_stress(stress));
}
