// What the hypoplastic laws share: the formulas, their integration, lanes,
// directions and work.

#include "../hypoplastic_fixture.h"

using namespace Sandglass;
using namespace HypoplasticReference;

namespace
{
  template <typename Law>
  class Hypoplasticity : public HypoplasticTest<Law>
  {};
} // namespace

TYPED_TEST_SUITE(Hypoplasticity, Laws, );



TYPED_TEST(Hypoplasticity, rate_is_as_printed)
{
  Draw draw(1);
  for (unsigned int i = 0; i < 1000; ++i)
    {
      const auto   stress = draw.stress(), strain = draw.direction();
      const double e        = draw.void_ratio();
      const auto   rate     = this->law.stress_rate(stress, e, strain, 1.);
      const auto   expected = components(HypoplasticReference::stress_rate(
        this->law, matrix(stress), e, matrix(strain)));
      ASSERT_LT((rate - expected).norm(), 1e-11 * expected.norm());
    }
}



// Increments of random direction and of 1e-7 to 1e-2, to which the material
// answers by up to several times its stress: to 1e-4 of the stress at the end,
// and of ten times p_t.
TYPED_TEST(Hypoplasticity, one_step_is_accurate)
{
  Draw   draw(2);
  double largest = 0.;
  for (unsigned int i = 0; i < 1000; ++i)
    {
      const SymmetricComponents<6> start = draw.stress();
      const SymmetricComponents<6> strain =
        std::pow(10., draw.number(-7., -2.)) * draw.direction();
      double                 e      = draw.void_ratio();
      std::array<double, 1>  state  = {{e}};
      SymmetricComponents<6> stress = start, expected = start;
      this->law.correct(stress, state, strain);
      integrate(this->law, expected, e, strain, 1000);
      largest =
        std::max(largest, (stress - expected).norm() / this->scale(expected));
      ASSERT_NEAR(state[0], e, 1e-8);
    }
  std::cout << "largest error " << largest << std::endl;
  EXPECT_LT(largest, 1e-4);
}



// Many steps from no stress, until 1 MPa: laterally confined, then also at
// constant volume, or random ones with a mean compression.
TYPED_TEST(Hypoplasticity, paths_are_accurate)
{
  SymmetricComponents<6> compression, shear;
  compression << 0., -1., 0., 0., 0., 0.;
  shear << 0.5, -1., 0.5, 0.3, 0., 0.;
  Draw draw(3);
  for (const double size : {1e-2, 1e-3, 1e-4})
    for (const unsigned int path : {0, 1, 2})
      {
        SymmetricComponents<6> stress   = SymmetricComponents<6>::Zero();
        SymmetricComponents<6> expected = stress;
        double                 e        = 0.95;
        std::array<double, 1>  state    = {{e}};
        double                 largest  = 0.;
        for (unsigned int i = 0; i < 30 && pressure(expected) < 1e6; ++i)
          {
            const SymmetricComponents<6> strain =
              size * (path == 0 || i < 10 ? compression :
                      path == 1           ? shear :
                                            0.3 * compression + draw.direction());
            this->law.correct(stress, state, strain);
            HypoplasticReference::integrate(
              this->law, expected, e, strain, 4000);
            largest =
              std::max(largest,
                       (stress - expected).norm() / this->scale(expected));
          }
        std::cout << "steps of " << size << ", path " << path
                  << ": largest error " << largest << ", pressure "
                  << pressure(expected) << std::endl;
        EXPECT_LT(largest, 1e-4);
      }
}



// A lane's result is that of one particle but for rounding, and does not depend
// on its neighbours at all: some need one step, others many.
TYPED_TEST(Hypoplasticity, lanes_are_particles)
{
  constexpr unsigned int n = 6;
  Draw                   draw(4);
  for (unsigned int i = 0; i < 500; ++i)
    {
      SymmetricComponents<n>        stress[4], strain[4];
      std::array<double, 1>         state[4];
      SymmetricComponents<n, Lanes> stresses, strains, reversed,
        reversed_strains;
      std::array<Lanes, 1> states, reversed_states;
      for (unsigned int lane = 0; lane < 4; ++lane)
        {
          stress[lane] = (draw.number(0., 1.) < 0.2 ? 0. : 1.) * draw.stress();
          strain[lane] =
            std::pow(10., draw.number(-7., -1.)) * draw.direction();
          state[lane][0] = draw.void_ratio();
        }
      for (unsigned int c = 0; c < n; ++c)
        {
          const auto in_lanes = [c](const auto &a, const bool is_reversed) {
            alignas(Lanes) double numbers[4];
            for (unsigned int lane = 0; lane < 4; ++lane)
              numbers[lane] = a[is_reversed ? 3 - lane : 0 + lane][c];
            return Lanes::load(numbers);
          };
          stresses[c]         = in_lanes(stress, false);
          strains[c]          = in_lanes(strain, false);
          reversed[c]         = in_lanes(stress, true);
          reversed_strains[c] = in_lanes(strain, true);
          if (c == 0)
            {
              states[0]          = in_lanes(state, false);
              reversed_states[0] = in_lanes(state, true);
            }
        }
      const Lanes work = this->law.correct(stresses, states, strains);

      // The same with three other neighbours, each in another lane.
      for (unsigned int c = 0; c < n; ++c)
        {
          alignas(Lanes) double numbers[4];
          reversed[c].store(numbers);
          numbers[0]  = c < 3 ? -1e3 : 0.;
          numbers[1]  = c < 3 ? -1e5 : 3e4;
          reversed[c] = Lanes::load(numbers);
        }
      this->law.correct(reversed, reversed_states, reversed_strains);
      for (unsigned int lane = 0; lane < 4; ++lane)
        {
          const double expected =
            this->law.correct(stress[lane], state[lane], strain[lane]);
          const double tolerance = 1e-9 * this->scale(stress[lane]);
          ASSERT_NEAR(work[lane], expected, tolerance * strain[lane].norm());
          ASSERT_DOUBLE_EQ(states[0][lane], state[lane][0]);
          for (unsigned int c = 0; c < n; ++c)
            {
              ASSERT_NEAR(stresses[c][lane], stress[lane][c], tolerance);
              if (lane < 2)
                {
                  ASSERT_EQ(stresses[c][lane], reversed[c][3 - lane]);
                }
            }
        }
    }
}



TYPED_TEST(Hypoplasticity, four_components_give_what_six_do)
{
  Draw draw(5);
  for (unsigned int i = 0; i < 500; ++i)
    {
      SymmetricComponents<6> stress = draw.stress();
      SymmetricComponents<6> strain = 1e-3 * draw.direction();
      stress.tail<2>().setZero();
      strain.tail<2>().setZero();
      SymmetricComponents<4>       in_plane        = stress.head<4>();
      const SymmetricComponents<4> strain_in_plane = strain.head<4>();
      std::array<double, 1>        state = {{0.9}}, state_in_plane = state;
      const double work = this->law.correct(stress, state, strain);
      ASSERT_NEAR(this->law.correct(in_plane, state_in_plane, strain_in_plane),
                  work,
                  1e-12 * std::abs(work) + 1e-15);
      ASSERT_LT((in_plane - stress.head<4>()).norm(),
                1e-11 * this->scale(stress));
      ASSERT_EQ(stress.tail<2>().norm(), 0.);
    }
}



// Stress and strain turned alike give a stress turned alike.
TYPED_TEST(Hypoplasticity, no_direction_is_special)
{
  Draw draw(6);
  for (unsigned int i = 0; i < 500; ++i)
    {
      SymmetricComponents<6> stress = draw.stress();
      SymmetricComponents<6> strain =
        std::pow(10., draw.number(-6., -2.)) * draw.direction();
      const auto             turn = draw.rotation();
      SymmetricComponents<6> turned =
        components(turn * matrix(stress) * turn.transpose());
      const SymmetricComponents<6> turned_strain =
        components(turn * matrix(strain) * turn.transpose());
      std::array<double, 1> state = {{0.9}}, turned_state = state;
      this->law.correct(stress, state, strain);
      this->law.correct(turned, turned_state, turned_strain);
      const auto expected =
        components(turn * matrix(stress) * turn.transpose());
      ASSERT_LT((turned - expected).norm(), 1e-9 * this->scale(stress));
    }
}



// Work is that of the mean of the stresses at start and end.
TYPED_TEST(Hypoplasticity, work)
{
  Draw draw(7);
  for (unsigned int i = 0; i < 100; ++i)
    {
      const SymmetricComponents<6> start  = draw.stress();
      const SymmetricComponents<6> strain = 1e-4 * draw.direction();
      SymmetricComponents<6>       end    = start;
      std::array<double, 1>        state  = {{0.9}};
      const double                 work = this->law.correct(end, state, strain);
      const SymmetricComponents<6> middle = 0.5 * (start + end);
      const double expected = (matrix(middle) * matrix(strain)).trace();
      ASSERT_NEAR(work, expected, 1e-10 * middle.norm() * strain.norm());
      EXPECT_EQ(this->law.energy_density(end, state), 0.);
    }
}
