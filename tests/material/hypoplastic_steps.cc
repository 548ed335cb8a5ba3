// The steps of the hypoplastic laws' integration: the bound of the deviator,
// and how often the law is evaluated.

#include "../hypoplastic_fixture.h"

using namespace Sandglass;
using namespace HypoplasticReference;



// Kolymbas' law unloads into tension: the deviator is held at its bound, which
// makes it an integration of first order there.
TEST(HypoplasticBounds, deviator)
{
  const Kolymbas         law{MaterialConstants{}};
  SymmetricComponents<6> stress, strain;
  stress << -275e3, -227e3, -86e3, 0., 0., 0.;
  strain << 4.1e-3, 4.7e-3, 4.2e-3, 3.4e-3, 1.3e-3, -1.9e-3;
  SymmetricComponents<6> expected = stress;
  double                 e        = 0.9;
  std::array<double, 1>  state    = {{e}};
  law.correct(stress, state, strain);
  integrate(law, expected, e, strain, 4000);
  const SymmetricComponents<6> shifted =
    stress - isotropic<6>(law.small_pressure);
  EXPECT_NEAR(von_mises_stress(shifted) / pressure(shifted), 3., 1e-9);
  EXPECT_LT((stress - expected).norm(), 0.03 * expected.norm());
}



namespace
{
  /// Counts how often a law is asked.
  struct CountedLaw
  {
    SymmetricComponents<6>
    stress_rate(const SymmetricComponents<6> &stress,
                const double                  void_ratio,
                const SymmetricComponents<6> &strain,
                const double                  norm) const
    {
      ++n_evaluations;
      return law.stress_rate(stress, void_ratio, strain, norm);
    }

    const VonWolffersdorff law{MaterialConstants{}};
    mutable unsigned int   n_evaluations = 0;
  };
} // namespace



// Small increments cost two evaluations; one that multiplies a stress of 10 kPa
// by several times, within 1e-4, costs some hundred, and not thousands.
TEST(HypoplasticCost, evaluations)
{
  SymmetricComponents<6> strain;
  strain << -0.3, -1., 0., 0.2, 0., 0.;
  for (const auto &[size, most] :
       {std::make_pair(1e-7, 2u), {1e-6, 2u}, {1e-4, 10u}, {1e-2, 130u}})
    {
      const CountedLaw                              law;
      const SymmetricComponents<6>                  increment = size * strain;
      const HypoplasticSteps<CountedLaw, 6, double> steps(
        law, law.law.small_pressure, increment, 0.9);
      steps.integrate(isotropic<6>(-1e4));
      std::cout << size << ": " << law.n_evaluations << " evaluations"
                << std::endl;
      EXPECT_LE(law.n_evaluations, most);
    }
}



// Material without stress that opens costs two as well.
TEST(HypoplasticCost, opening)
{
  const CountedLaw                              law;
  const SymmetricComponents<6>                  opening = isotropic<6>(1e-2);
  const HypoplasticSteps<CountedLaw, 6, double> steps(law,
                                                      law.law.small_pressure,
                                                      opening,
                                                      0.9);
  steps.integrate(isotropic<6>(-law.law.small_pressure));
  EXPECT_EQ(law.n_evaluations, 2u);
}
