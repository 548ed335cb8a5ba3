#include <sandglass/continuum/plane_strain.h>
#include <sandglass/flow/particle_in_cell/stress_update.h>
#include <sandglass/material/drucker_prager.h>
#include <sandglass/material/von_wolffersdorff.h>

#include <gtest/gtest.h>

#include <array>

using namespace Sandglass;

namespace
{
  constexpr double density = 1500.; // kg/m^3

  /// A particle under a pressure, of a law, that gets a volumetric strain.
  template <typename Law>
  struct StressUpdateTest
  {
    static constexpr unsigned int n_numbers = n_state_numbers<Law>();

    using Layout = ParticleLayout<2, 4, n_numbers>;
    using State  = ParticleState<Layout, double>;

    /// The pressure at the end of the step in Pa.
    double
    pressure_after(const double                   density_share,
                   const double                   strain,
                   const ParticleStageParameters &parameters = {}) const
    {
      const Law          law(constants);
      const StressUpdate update(law, density, parameters);
      State              state{};
      state.density      = density_share * density * (1. + strain);
      state.stress       = isotropic<4>(-pressure_before);
      const auto initial = law.initial_state();
      for (unsigned int i = 0; i < n_numbers; ++i)
        state.law_state[i] = initial[i];

      using Increment = PlaneStrain::Increment<double>;
      const std::array<std::array<double, 2>, 2> gradient{
        {{{strain / 2., 0.}}, {{0., strain / 2.}}}};
      const Increment increment(gradient, 0.);
      const auto      prediction = law.predict(increment, 0.);
      using Prediction           = std::decay_t<decltype(prediction)>;
      update(state,
             ParticleDeformation<Prediction,
                                 std::decay_t<decltype(increment.rotation)>,
                                 double>{prediction,
                                         increment.rotation,
                                         1. / (1. + strain)});
      return pressure(state.stress);
    }

    MaterialConstants constants;
    double            pressure_before = 1e4; ///< in Pa
  };

  constexpr double strain          = 1e-4;
  const double     loosest_density = ParticleStageParameters().loosest_density;
} // namespace



// Material that has loosened resists; separated material has no stress.
TEST(StressUpdate, FollowsTheDensity)
{
  const StressUpdateTest<DruckerPrager> particle{};
  const double dense = particle.pressure_after(1.001, -strain);
  ASSERT_GT(dense, particle.pressure_before);
  EXPECT_EQ(particle.pressure_after(1.001 * loosest_density, -strain), dense);
  EXPECT_EQ(particle.pressure_after(0.999 * loosest_density, -strain), 0.);
}



TEST(StressUpdate, ParametersDecideWhatIsLoose)
{
  const StressUpdateTest<DruckerPrager> particle{};
  const double dense = particle.pressure_after(1.001, -strain);

  ParticleStageParameters strict;
  strict.loosest_density = 1.;
  EXPECT_EQ(particle.pressure_after(0.999, -strain, strict), 0.);

  ParticleStageParameters paper;
  paper.density_update = DensityUpdate::paper;
  EXPECT_EQ(particle.pressure_after(0.5, -strain, paper), dense);
}



// A particle meets the others in the middle of the step in which it becomes
// dense, so that it is not thrown back faster than it came.
TEST(StressUpdate, ResistsHalfOfTheStrainThatMakesItDense)
{
  StressUpdateTest<DruckerPrager> particle{};
  particle.pressure_before = 0.;
  constexpr double strain  = -0.02;
  const double     all     = particle.pressure_after(1., strain);
  const double     middle  = 0.5 * (1. + 1. / (1. + strain));
  EXPECT_NEAR(particle.pressure_after(loosest_density * middle, strain) / all,
              0.5,
              1e-10);

  ParticleStageParameters paper;
  paper.density_update = DensityUpdate::paper;
  EXPECT_EQ(particle.pressure_after(loosest_density * middle, strain, paper),
            all);
}



// By as much as cohesion lets it expand, material may be looser.
TEST(StressUpdate, CohesiveMaterialMayBeLooser)
{
  StressUpdateTest<DruckerPrager> particle{};
  particle.constants.cohesion = 1e5;
  const double loosest =
    loosest_density * DruckerPrager(particle.constants).loosest_density_share();
  ASSERT_LT(loosest, 0.9);
  const double dense = particle.pressure_after(1.001, -strain);
  EXPECT_EQ(particle.pressure_after(1.001 * loosest, -strain), dense);
  EXPECT_EQ(particle.pressure_after(0.999 * loosest, -strain), 0.);
}



TEST(StressUpdate, LeavesLawsThatKnowTheDensity)
{
  const StressUpdateTest<VonWolffersdorff> particle{};
  const double                             loosest =
    VonWolffersdorff(particle.constants).loosest_density_share();
  const double dense = particle.pressure_after(1.001, -strain);
  EXPECT_EQ(particle.pressure_after(1.001 * loosest, -strain), dense);
  EXPECT_EQ(particle.pressure_after(0.999 * loosest, -strain), 0.);
}
