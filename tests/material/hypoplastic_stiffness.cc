// The stiffness bound of the hypoplastic laws, and their tangent.

#include "../hypoplastic_fixture.h"

using namespace Sandglass;
using namespace HypoplasticReference;

namespace
{
  template <typename Law>
  class HypoplasticStiffness : public HypoplasticTest<Law>
  {};
} // namespace

TYPED_TEST_SUITE(HypoplasticStiffness, Laws, );



// No direction of strain finds a stiffer material than the bound, and the bound
// isn't much stiffer than the stiffest.
TYPED_TEST(HypoplasticStiffness, stiffness_bound)
{
  Draw   draw(8);
  double smallest_largest = 1.;
  for (unsigned int i = 0; i < 300; ++i)
    {
      const auto                  stress = draw.stress();
      const std::array<double, 1> state  = {{draw.void_ratio()}};
      const Elasticity bound = this->law.stiffness_bound(stress, state);
      const auto       shifted =
        SymmetricComponents<6>(stress - isotropic<6>(this->law.small_pressure));
      double largest = 0.;
      for (unsigned int j = 0; j < 300; ++j)
        {
          const auto strain = draw.direction();
          const auto rate =
            this->law.stress_rate(shifted, state[0], strain, 1.);
          const double share = double_contraction(strain, rate) /
                               double_contraction(strain, bound.stress(strain));
          largest = std::max(largest, share);
        }
      ASSERT_LE(largest, 1.);
      smallest_largest = std::min(smallest_largest, largest);
    }
  std::cout << "at least " << smallest_largest << " of the bound is reached"
            << std::endl;
  EXPECT_GT(smallest_largest, 0.5);
}



// Where all directions are alike, unloading is as stiff as the bound says.
TYPED_TEST(HypoplasticStiffness, stiffness_bound_of_isotropic_stress_is_sharp)
{
  const Elasticity bound   = this->law.stiffness_bound();
  const auto       shifted = isotropic<6>(-this->law.small_pressure);
  const auto       strain  = isotropic<6>(1.);
  const auto       rate    = this->law.stress_rate(shifted,
                                          this->law.initial_void_ratio,
                                          strain,
                                          std::sqrt(3.));
  EXPECT_NEAR(rate[0] / (3. * bound.bulk_modulus()), 1., 1e-12);
}



// Against differences of the accurate integration, in increments as large as
// the state at rest takes.
TYPED_TEST(HypoplasticStiffness, tangent)
{
  Draw draw(9);
  for (unsigned int i = 0; i < 30; ++i)
    {
      const SymmetricComponents<6> start = draw.stress();
      SymmetricComponents<6>       mean  = isotropic<6>(-1.);
      const Increment increment{std::pow(10., draw.number(-5., -2.)) *
                                (mean + draw.direction())};
      const std::array<double, 1> state = {{draw.void_ratio()}};
      const auto tangent = this->law.tangent(start, state, increment, 0.);

      const auto direction  = draw.direction();
      const auto difference = [&](const double on_stress,
                                  const double on_strain) {
        SymmetricComponents<6> ends[2];
        for (const int sign : {1, -1})
          {
            double e             = state[0];
            ends[(1 - sign) / 2] = start + sign * on_stress * direction;
            const auto strain    = SymmetricComponents<6>(
              increment.strain + sign * on_strain * direction);
            HypoplasticReference::integrate(
              this->law, ends[(1 - sign) / 2], e, strain, 2000);
          }
        return SymmetricComponents<6>(0.5 * (ends[0] - ends[1]) /
                                      (on_stress + on_strain));
      };
      const auto by_stress = difference(1e-4 * this->scale(start), 0.);
      const auto by_strain =
        difference(0., 1e-3 * std::sqrt(increment.strain.squaredNorm()));
      EXPECT_LT((tangent.by_stress * direction - by_stress).norm(),
                0.02 * tangent.by_stress.norm());
      EXPECT_LT((tangent.by_strain * direction - by_strain).norm(),
                0.02 * tangent.by_strain.norm());
    }
}
