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



TEST(EurocodePressures, SquatWallsAndFarOutletsAreLeftOut)
{
  expect_nothing(plane_silo(1.).on_wall(Load::filling, 0.5));
  expect_nothing(plane_silo(1.).on_hopper(Load::filling, 1.2));
  // outlet at 0.25 d_c and beyond
  const auto near = plane_silo(3., nothing, 0.25);
  EXPECT_GT(near.on_wall(Load::discharge, 1.).normal, 0.);
  const auto far = plane_silo(3., nothing, 0.26);
  EXPECT_GT(far.on_wall(Load::filling, 1.).normal, 0.);
  expect_nothing(far.on_wall(Load::discharge, 1.));
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
  // No steep hopper, and none.
  expect_nothing(plane_silo(2., 0.626).on_hopper(Load::filling, 2.5));
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
        const double slope = 0.4, hopper_height = 0.5 / slope;
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
