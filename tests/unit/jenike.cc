#include <sandglass/output/jenike.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace Sandglass;

namespace
{
  constexpr double degree = 3.14159265358979323846 / 180.;

  double
  wall_stress(const Formulation formulation,
              const double      friction_angle,
              const double      hopper_angle,
              const double      wall_friction_angle)
  {
    return Jenike{formulation,
                  friction_angle * degree,
                  wall_friction_angle * degree,
                  hopper_angle * degree}
      .radial_stress()
      .normal;
  }
} // namespace



// Integrated from the field's equations by another program.
TEST(Jenike, radial_stress_in_wedges)
{
  const double delta_25 =
    std::asin(18. * std::sin(25. * degree) /
              (9. - std::pow(std::sin(25. * degree), 2)) / std::sqrt(3.)) /
    degree;
  const double delta_30 =
    std::asin(18. * 0.5 / (9. - 0.25) / std::sqrt(3.)) / degree;
  const auto wedge = Formulation::plane_strain;
  EXPECT_NEAR(wall_stress(wedge, delta_25, 10., 5.), 1.2243, 2e-4);
  EXPECT_NEAR(wall_stress(wedge, delta_25, 10., 20.), 0.4523, 2e-4);
  EXPECT_NEAR(wall_stress(wedge, delta_25, 20., 10.), 1.2885, 2e-4);
  EXPECT_NEAR(wall_stress(wedge, delta_25, 20., 20.), 0.8687, 2e-4);
  EXPECT_NEAR(wall_stress(wedge, delta_30, 10., 10.), 0.6896, 2e-4);
  EXPECT_NEAR(wall_stress(wedge, delta_30, 20., 15.), 0.8881, 2e-4);
}



TEST(Jenike, radial_stress_in_cones)
{
  const auto cone = Formulation::axisymmetric;
  EXPECT_NEAR(wall_stress(cone, 40., 15., 20.), 0.2773, 2e-4);
  EXPECT_NEAR(wall_stress(cone, 50., 20., 20.), 0.3294, 2e-4);
  EXPECT_NEAR(wall_stress(cone, 40., 15., 10.), 0.3950, 2e-4);
}



TEST(Jenike, mass_flow_limit_of_cones)
{
  const auto limit = [](const double friction_angle, const double wall) {
    return Jenike{Formulation::axisymmetric,
                  friction_angle * degree,
                  wall * degree,
                  0.}
             .mass_flow_limit() /
           degree;
  };
  EXPECT_NEAR(limit(30., 10.), 44.8, 0.05);
  EXPECT_NEAR(limit(30., 25.), 18.7, 0.05);
  EXPECT_NEAR(limit(40., 15.), 33.7, 0.05);
}



// Jenike's charts of flow factors have 1.1 to 1.7 for such hoppers.
TEST(Jenike, flow_factor_and_widths)
{
  const Jenike hopper{Formulation::axisymmetric,
                      50. * degree,
                      20. * degree,
                      20. * degree};
  EXPECT_GT(hopper.flow_factor(), 1.0);
  EXPECT_LT(hopper.flow_factor(), 1.7);
  EXPECT_NEAR(hopper.arching_width(3000., 15000.),
              (2. + 20. / 60.) / 5.,
              1e-12);
  EXPECT_NEAR(hopper.rathole_diameter(3000., 15000.),
              4.3 * std::tan(50. * degree) / 5.,
              1e-12);
  // No radial field with a flat bottom.
  EXPECT_TRUE(
    std::isnan(Jenike{Formulation::plane_strain, 30. * degree, 20. * degree, 0.}
                 .flow_factor()));
}
