#include <sandglass/output/eurocode_pressures.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace Sandglass;

namespace
{
  using Load = EurocodePressures::Load;

  // A plane silo 1 m wide: gamma = 15 kN/m^3, A / U = 0.5 m, K = 0.5, mu = 0.4,
  // so z_o = 0.5 / (0.5 0.4) = 2.5 m and p_ho = gamma K z_o = 18750 Pa.
  constexpr double density = 15000., lateral_ratio = 0.5, mu = 0.4;
  const double     nothing = std::nan("");

  EurocodePressures
  plane_silo(const double wall_height,
             const double hopper_slope = nothing,
             const double eccentricity = 0.)
  {
    return {{Formulation::plane_strain,
             1.,
             wall_height,
             eccentricity,
             hopper_slope,
             30.},
            {density, 0.5, lateral_ratio, mu}};
  }

  void
  expect_pressure(const WallPressure &pressure,
                  const double        normal,
                  const double        tangential)
  {
    EXPECT_NEAR(pressure.normal, normal, 1.);
    EXPECT_NEAR(pressure.tangential, tangential, 1.);
  }

  void
  expect_nothing(const WallPressure &pressure)
  {
    EXPECT_TRUE(std::isnan(pressure.normal));
    EXPECT_TRUE(std::isnan(pressure.tangential));
  }
} // namespace



TEST(EurocodePressures, SlenderWalls)
{
  // z = 2.5 m: 18750 (1 - 1/e) = 11852.3 Pa; times 1.15, times 1.10
  for (const double height : {2., 5.})
    {
      const auto silo = plane_silo(height);
      expect_pressure(silo.on_wall(Load::filling, 2.5), 11852.3, 4740.9);
      expect_pressure(silo.on_wall(Load::discharge, 2.5), 13630.1, 5215.0);
    }
}



TEST(EurocodePressures, IntermediateWalls)
{
  // h_c / d_c = 1.6, C_S = 0.6; z = 1.25 m: 15000 0.5 1.25 / 1.5 = 6250 Pa;
  // times 1.09, times 1.06
  const auto silo = plane_silo(1.6);
  expect_pressure(silo.on_wall(Load::filling, 1.25), 6250., 2500.);
  expect_pressure(silo.on_wall(Load::discharge, 1.25), 6812.5, 2650.);
}



TEST(EurocodePressures, SquatWalls)
{
  // z = 0.5 m: 15000 0.5 0.5 / 1.2 = 3125 Pa, the same on discharge
  const auto silo = plane_silo(1.);
  for (const Load load : {Load::filling, Load::discharge})
    expect_pressure(silo.on_wall(load, 0.5), 3125., 1250.);
  EXPECT_GT(plane_silo(0.41).on_wall(Load::filling, 0.2).normal, 0.);
}



TEST(EurocodePressures, RetainingSilosAndFarOutletsAreLeftOut)
{
  expect_nothing(plane_silo(0.4).on_wall(Load::filling, 0.2));
  expect_nothing(plane_silo(0.4, 0.5).on_hopper(Load::filling, 0.5));
  EXPECT_TRUE(std::isnan(plane_silo(0.4).patch(Load::filling, 0.2)));
  // outlet at 0.25 d_c and beyond
  const auto near = plane_silo(3., nothing, 0.25);
  EXPECT_GT(near.on_wall(Load::discharge, 1.).normal, 0.);
  const auto far = plane_silo(3., nothing, 0.26);
  EXPECT_GT(far.on_wall(Load::filling, 1.).normal, 0.);
  expect_nothing(far.on_wall(Load::discharge, 1.));
  EXPECT_TRUE(std::isnan(far.patch(Load::discharge, 1.)));
}



// A round silo of wheat (C_op = 0.5), h_c / d_c = 3: C_pf = 0.21 0.5 (1 - e^-3)
// = 0.0997724; with the outlet 0.1 d_c off the middle E = 0.2 and C_pe = 0.42
// 0.5 1.08 (1 - e^-3) = 0.215508. p_hf = 9375 (1 - e^-0.8) = 5162.54 Pa at z =
// 1 m, where z_o = 1.25 m, and p_he is 1.15 times that.
TEST(EurocodePressures, PatchLoads)
{
  EurocodePressures::Silo wheat{
    Formulation::axisymmetric, 1., 3., 0.1, nothing, 30.};
  wheat.patch_load_factor = 0.5;
  const Janssen           janssen{density, 0.25, lateral_ratio, mu};
  const EurocodePressures round(wheat, janssen);
  EXPECT_NEAR(round.patch(Load::filling, 1.), 515.08, 0.1);
  EXPECT_NEAR(round.patch(Load::discharge, 1.), 1279.46, 0.1);
  // Not round: a band of 0.36 times the pressure.
  wheat.formulation = Formulation::plane_strain;
  EXPECT_NEAR(EurocodePressures(wheat, janssen).patch(Load::filling, 1.),
              0.36 * 515.08,
              0.1);
  // h_c / d_c = 1.1, E = 0.2: C_pe = 0.272 0.5 0.3 = 0.0408; C_h = 1.015 and
  // p_hf = 15000 0.5 0.5 / 1.4 = 2678.57 Pa at z = 0.5 m.
  wheat.formulation = Formulation::axisymmetric;
  wheat.wall_height = 1.1;
  EXPECT_NEAR(EurocodePressures(wheat, janssen).patch(Load::discharge, 0.5),
              110.92,
              0.1);
  // Neither factor is less than zero.
  wheat.wall_height         = 0.9;
  wheat.outlet_eccentricity = 0.;
  for (const Load load : {Load::filling, Load::discharge})
    EXPECT_EQ(EurocodePressures(wheat, janssen).patch(load, 0.5), 0.);
}



// A wedge with tan(beta) = 0.5, limit (1 - K) / (2 mu) = 0.625; h_h = 1 m. At
// the transition z = 2 m: p_v = 37500 (1 - exp(-0.8)) = 20650.2 Pa. Half way
// down, x / h_h = 0.5:
// filling: F = 1 - 0.2 0.4 / 0.9 = 0.911111, n = 0.8 0.8 = 0.64,
//   p_v = 15000 (0.5 - 0.5^0.64) / (0.64 - 1) + 20650.2 0.5^0.64
//       = 5904.7 + 13251.5 = 19156.2 Pa
// discharge: phi_w = 21.8014, epsilon = 21.8014 + asin(2 0.371391)
//   = 69.7703 degrees, beta = 26.5651 degrees,
//   F = (1 + 0.5 0.345785) / (1 - 0.5 cos(122.9004)) = 0.922382,
//   n = 0.922382 1.8 - 1 = 0.660288, p_v = 18928.1 Pa
TEST(EurocodePressures, WedgeHopper)
{
  const auto silo = plane_silo(2., 0.5);
  expect_pressure(silo.on_hopper(Load::filling, 2.5), 17453., 6981.);
  expect_pressure(silo.on_hopper(Load::discharge, 2.5), 17459., 6984.);
  // Shallow: tan(beta) = 1, mu_heff = 0.25, F = 1 - 0.2 / 5 = 0.96, n = 0.2,
  // h_h = 0.5 m, x / h_h = 0.5: p_v = 9375 (0.5^0.2 - 0.5) + 20650.2 0.5^0.2
  // = 21451.0 Pa, on filling and on discharge.
  const auto shallow = plane_silo(2., 1.);
  for (const Load load : {Load::filling, Load::discharge})
    expect_pressure(shallow.on_hopper(load, 2.25), 20593., 5148.);
  // No hopper.
  expect_nothing(plane_silo(2.).on_hopper(Load::filling, 2.5));
}



// The hopper's walls and the pressure at the transition carry the hopper's
// content: integrals over x from the apex.
TEST(EurocodePressures, HoppersAreInEquilibrium)
{
  for (const auto formulation :
       {Formulation::plane_strain, Formulation::axisymmetric})
    for (const Load load : {Load::filling, Load::discharge})
      {
        const bool   is_plane = formulation == Formulation::plane_strain;
        const double height   = 1.5; // intermediate
        // Steep and shallow.
        for (const double slope : {0.4, 1.2})
          {
            const double            hopper_height = 0.5 / slope;
            const EurocodePressures silo(
              {formulation, 1., height, 0., slope, 30.},
              {density, is_plane ? 0.5 : 0.25, lateral_ratio, mu});

            // The lifting force over pi in cones, over 2 in wedges.
            double                 lift = 0.;
            constexpr unsigned int n    = 20000;
            for (unsigned int i = 0; i < n; ++i)
              {
                const double x = hopper_height * (i + 0.5) / n;
                const auto   pressure =
                  silo.on_hopper(load, height + hopper_height - x);
                lift += (slope * pressure.normal + pressure.tangential) *
                        (is_plane ? 1. : 2. * slope * x) * hopper_height / n;
              }
            const double z_o = (is_plane ? 0.5 : 0.25) / (lateral_ratio * mu);
            const double transition = density * z_o * std::log1p(height / z_o);
            const double load_above = transition * (is_plane ? 0.5 : 0.25);
            const double weight =
              density * hopper_height * (is_plane ? 0.5 / 2. : 0.25 / 3.);
            EXPECT_NEAR(lift / (load_above + weight), 1., 1e-4);
          }
      }
}
