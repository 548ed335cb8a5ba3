// Hypoplastic material where stress vanishes, and what no law should break on:
// tension, huge increments, numbers that are none.

#include "../hypoplastic_fixture.h"

using namespace Sandglass;
using namespace HypoplasticReference;

namespace
{
  template <typename Law>
  class HypoplasticWithoutStress : public HypoplasticTest<Law>
  {
  protected:
    /// Stress after an increment, from a stress.
    SymmetricComponents<6>
    after(SymmetricComponents<6>        stress,
          const SymmetricComponents<6> &strain,
          const double                  void_ratio = 0.9) const
    {
      std::array<double, 1> state = {{void_ratio}};
      this->law.correct(stress, state, strain);
      return stress;
    }

    const SymmetricComponents<6> zero = SymmetricComponents<6>::Zero();
  };
} // namespace

TYPED_TEST_SUITE(HypoplasticWithoutStress, Laws, );



// Loaded from zero, material gets the stiffness of p_t, and then more.
TYPED_TEST(HypoplasticWithoutStress, can_be_loaded)
{
  SymmetricComponents<6> strain = this->zero;
  strain[1]                     = -1e-8;
  const double first            = pressure(this->after(this->zero, strain));
  const double bulk_modulus     = first / 1e-8;
  EXPECT_GT(bulk_modulus, 0.);
  EXPECT_LT(bulk_modulus, this->law.stiffness_bound().bulk_modulus());
  EXPECT_GT(bulk_modulus, 0.1 * this->law.stiffness_bound().bulk_modulus());
  strain[1] = -0.03;
  EXPECT_GT(pressure(this->after(this->zero, strain)),
            2. * 0.03 * bulk_modulus);
}



TYPED_TEST(HypoplasticWithoutStress, tension_and_rest_leave_no_stress)
{
  const auto tension = SymmetricComponents<6>(isotropic<6>(1e3));
  EXPECT_EQ(this->after(this->zero, this->zero), this->zero);
  EXPECT_EQ(this->after(tension, this->zero), this->zero);
  for (const double size : {1e-9, 1e-5, 1e-3, 0.1, 1.})
    EXPECT_EQ(this->after(this->zero, isotropic<6>(size)), this->zero);

  // Unloading ends at zero too, and not below.
  EXPECT_EQ(this->after(isotropic<6>(-1e4), isotropic<6>(0.1)), this->zero);
}



// The void ratio keeps account of the opening, and no stress comes back before
// pressure does.
TYPED_TEST(HypoplasticWithoutStress, void_ratio_follows_the_volume)
{
  SymmetricComponents<6> stress  = this->zero;
  std::array<double, 1>  state   = {{0.9}};
  const auto             opening = SymmetricComponents<6>(isotropic<6>(1e-3));
  for (unsigned int i = 0; i < 100; ++i)
    this->law.correct(stress, state, opening);
  EXPECT_NEAR(state[0], 1.9 * std::exp(0.3) - 1., 1e-8);
  EXPECT_EQ(stress, this->zero);
  const auto closing = SymmetricComponents<6>(-opening);
  for (unsigned int i = 0; i < 100; ++i)
    this->law.correct(stress, state, closing);
  EXPECT_NEAR(state[0], 0.9, 1e-8);
}



TYPED_TEST(HypoplasticWithoutStress, extremes_stay_finite)
{
  Draw draw(11);
  for (unsigned int i = 0; i < 2000; ++i)
    {
      SymmetricComponents<6> stress =
        std::pow(10., draw.number(-12., 9.)) * draw.direction();
      const double sizes[] = {0., 1e-300, 1e-12, 1e-3, 1e-2, 0.1, 1.};
      const auto   strain  = SymmetricComponents<6>(
        sizes[int(draw.number(0., 7.))] * draw.direction());
      const double e[] = {-0.5, 0., 1e-9, 0.4, 0.677, 1.212, 1.5, 100.};
      std::array<double, 1> state = {{e[int(draw.number(0., 8.))]}};
      const double          work  = this->law.correct(stress, state, strain);
      ASSERT_TRUE(stress.allFinite() && std::isfinite(work)) << i;
      ASSERT_TRUE(std::isfinite(state[0]));
      ASSERT_TRUE(pressure(stress) > 0. || stress == this->zero);

      const Elasticity bound = this->law.stiffness_bound(stress, state);
      ASSERT_GT(bound.confined_modulus(), 0.);
      ASSERT_TRUE(std::isfinite(bound.confined_modulus()));
      if (i % 20 == 0)
        {
          const auto tangent =
            this->law.tangent(stress, state, Increment{strain}, 0.1);
          ASSERT_TRUE(tangent.by_stress.allFinite());
          ASSERT_TRUE(tangent.by_strain.allFinite());
        }
    }
}



// What isn't a number spreads to all components, and the integration ends.
TYPED_TEST(HypoplasticWithoutStress, not_a_number_stays_visible)
{
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  const auto   stress       = SymmetricComponents<6>(isotropic<6>(-1e4));
  for (int c = 0; c < 6; ++c)
    {
      SymmetricComponents<6> spoiled = stress, strain = this->zero;
      spoiled[c] = not_a_number;
      strain[c]  = not_a_number;
      for (const auto &result : {this->after(spoiled, this->zero),
                                 this->after(spoiled, isotropic<6>(-1e-2)),
                                 this->after(stress, strain)})
        for (int i = 0; i < 6; ++i)
          EXPECT_TRUE(std::isnan(result[i])) << c << ' ' << i;
    }
}



// Points without stress keep a stiffness in Newton's method, others the share
// that it asks for.
TYPED_TEST(HypoplasticWithoutStress, tangent)
{
  const std::array<double, 1> state = {{0.9}};
  const auto   opening = Increment{SymmetricComponents<6>(isotropic<6>(1e-3))};
  const auto   unstressed = this->law.tangent(this->zero, state, opening, 0.);
  const double volume     = 1.9 * std::exp(3e-3) - 1.;
  const std::array<double, 1> after = {{volume}};
  const ComponentMatrix<6>    elastic =
    this->law.stiffness_bound(this->zero, after).template stiffness<6>();
  EXPECT_LT((unstressed.by_strain - elastic).norm(), 1e-6 * elastic.norm());

  const auto               stress = SymmetricComponents<6>(isotropic<6>(-1e4));
  const Increment          rest{this->zero};
  const auto               whole = this->law.tangent(stress, state, rest, 1.);
  const ComponentMatrix<6> bound =
    this->law.stiffness_bound(stress, state).template stiffness<6>();
  EXPECT_LT((whole.by_strain - bound).norm(), 1e-12 * bound.norm());
  EXPECT_TRUE(whole.by_stress.isIdentity(1e-12));
}
