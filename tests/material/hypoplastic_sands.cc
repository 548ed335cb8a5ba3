// Hypoplastic laws against closed forms, the figures known for sets of
// constants, and measured tests of Karlsruhe fine sand.

#include <sandglass/material/kolymbas.h>
#include <sandglass/material/von_wolffersdorff.h>
#include <sandglass/material/wu_bauer.h>

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>
#include <vector>

#include "../element_driver.h"

using namespace Sandglass;

namespace
{
  /// The rows of a file in tests/data; the first column is a name.
  std::vector<std::pair<std::string, std::vector<double>>>
  read_data(const std::string &name)
  {
    std::ifstream file(SANDGLASS_SOURCE_DIR "/tests/data/" + name);
    std::vector<std::pair<std::string, std::vector<double>>> rows;
    std::string                                              line;
    bool                                                     is_heading = true;
    while (std::getline(file, line))
      {
        if (line[0] == '#')
          continue;
        if (is_heading)
          {
            is_heading = false;
            continue;
          }
        std::istringstream cells(line);
        std::string        cell;
        std::getline(cells, cell, ',');
        rows.emplace_back(cell, std::vector<double>());
        while (std::getline(cells, cell, ','))
          rows.back().second.push_back(std::atof(cell.c_str()));
      }
    return rows;
  }

  /// A law with constants of its own, and with a pressure p_t that leaves no
  /// trace in closed forms.
  template <typename Law>
  Law
  law_with(std::map<std::string, double> constants)
  {
    MaterialConstants material;
    material.law_constants        = std::move(constants);
    material.law_constants["p_t"] = 1e-3;
    return Law(material);
  }

  /// Friction angle in degrees of a triaxial state.
  template <typename Law>
  double
  friction_angle(const ElementDriver<Law> &test)
  {
    return std::asin(test.deviatoric_stress() /
                     (test.axial_stress() + test.lateral_stress())) *
           180. / M_PI;
  }

  /// A drained triaxial test of a law whose stiffness is in proportion to
  /// stress, far enough for its final state.
  template <typename Law>
  void
  check_triaxial(const Law   &law,
                 const double stiffness,
                 const double angle,
                 const double tolerance,
                 const bool   keeps_volume)
  {
    ElementDriver<Law> test(law, 1e5, 1e5, 0.8);
    test.compress_triaxial(1e-7);
    EXPECT_NEAR(test.deviatoric_stress() / (1e5 * 1e-7), stiffness, 0.5);
    for (unsigned int i = 0; i < 4000; ++i)
      test.compress_triaxial(1e-4);
    EXPECT_NEAR(friction_angle(test), angle, tolerance);
    if (keeps_volume)
      EXPECT_NEAR(test.lateral_ratio(), -0.5, 3e-3);
    else
      EXPECT_LT(test.lateral_ratio(), -0.51);
  }
} // namespace



// At the critical void ratio and q = 2 sin(phi_c) / (1 - sin(phi_c)) sigma_3,
// neither stress nor volume change.
TEST(VonWolffersdorff, critical_state)
{
  const auto   law = law_with<VonWolffersdorff>({});
  const double s   = std::sin(33.1 * M_PI / 180.);
  for (const double lateral : {1e3, 1e5, 1e6})
    {
      const double                 axial = lateral * (1. + 2. * s / (1. - s));
      const SymmetricComponents<4> stress(-lateral, -axial, -lateral, 0.);
      const SymmetricComponents<4> strain(0.5, -1., 0.5, 0.);
      const double                 e_c =
        1.054 * std::exp(-std::pow(3. * pressure(stress) / 4e9, 0.27));
      const double norm = std::sqrt(1.5);
      const auto   rate = law.stress_rate(stress, e_c, strain, norm);
      const double stiffness =
        law.stress_rate(stress, e_c, SymmetricComponents<4>(-strain), norm)
          .norm();
      EXPECT_LT(rate.norm(), 1e-12 * stiffness);
    }
}



// A loose and a dense sample approach it.
TEST(VonWolffersdorff, samples_reach_the_critical_state)
{
  const auto   law = law_with<VonWolffersdorff>({});
  const double s   = std::sin(33.1 * M_PI / 180.);
  for (const double void_ratio : {0.75, 1.02})
    {
      ElementDriver<VonWolffersdorff> test(law, 1e5, 1e5, void_ratio);
      for (unsigned int i = 0; i < 20000; ++i)
        test.compress_triaxial(1e-4);
      EXPECT_NEAR(test.deviatoric_stress() / (2. * s / (1. - s) * 1e5),
                  1.,
                  0.01);
      const double p   = 1e5 + test.deviatoric_stress() / 3.;
      const double e_c = 1.054 * std::exp(-std::pow(3. * p / 4e9, 0.27));
      EXPECT_NEAR(test.void_ratio(), e_c, 0.02);
    }
}



TEST(WuBauer, known_sets_of_constants)
{
  check_triaxial(law_with<WuBauer>({}), 150., 24.9, 0.05, true);
  check_triaxial(
    law_with<WuBauer>(
      {{"C_1", -69.4}, {"C_2", -673.1}, {"C_3", -655.9}, {"C_4", 699.6}}),
    210.,
    29.4,
    0.1,
    true);
  check_triaxial(
    law_with<WuBauer>(
      {{"C_1", -106.5}, {"C_2", -801.5}, {"C_3", -797.1}, {"C_4", 1077.7}}),
    320.,
    40.5,
    0.1,
    false);
}



// The four equations from which the default constants follow.
TEST(Kolymbas, default_constants)
{
  const auto law = law_with<Kolymbas>({});
  check_triaxial(law, 150., 24.9, 0.01, true);
  ElementDriver<Kolymbas> test(law, 1e3, 1e3, 0.8);
  for (unsigned int i = 0; i < 1000; ++i)
    test.compress_confined(1e-4);
  EXPECT_NEAR(test.lateral_stress() / test.axial_stress(),
              1. - std::sin(24.9 * M_PI / 180.),
              1e-3);
}



// Which law is meant, which constants it takes, and the density below which its
// grains don't touch.
TEST(HypoplasticLaws, material_constants)
{
  MaterialConstants constants;
  constants.void_ratio = 0.9;
  for (const std::string model :
       {"Drucker-Prager", "von Wolffersdorff", "Wu-Bauer", "Kolymbas"})
    {
      constants.model = model;
      EXPECT_EQ(VonWolffersdorff::is_meant(constants),
                model == "von Wolffersdorff");
      EXPECT_EQ(WuBauer::is_meant(constants), model == "Wu-Bauer");
      EXPECT_EQ(Kolymbas::is_meant(constants), model == "Kolymbas");
    }
  EXPECT_EQ(VonWolffersdorff(constants).initial_state()[0], 0.9);
  EXPECT_DOUBLE_EQ(VonWolffersdorff(constants).loosest_density_share(),
                   1.9 / 2.212);
  EXPECT_DOUBLE_EQ(WuBauer(constants).loosest_density_share(), 1.9 / 2.08);
  EXPECT_DOUBLE_EQ(Kolymbas(constants).loosest_density_share(), 1.9 / 2.08);

  constants.law_constants = {{"e_i0", 1.3}, {"p_t", 2.}};
  EXPECT_DOUBLE_EQ(VonWolffersdorff(constants).loosest_density_share(),
                   1.9 / 2.3);
  EXPECT_EQ(VonWolffersdorff(constants).small_pressure, 2.);
}



// Void ratios at all vertical stresses of the first loading.
TEST(VonWolffersdorff, measured_oedometer_tests)
{
  const VonWolffersdorff                       law{MaterialConstants{}};
  std::string                                  name;
  double                                       largest = 0.;
  unsigned int                                 n_tests = 0;
  std::vector<ElementDriver<VonWolffersdorff>> tests;
  for (const auto &[test_name, row] :
       read_data("karlsruhe-fine-sand-oedometer.csv"))
    {
      if (test_name != name)
        {
          const double axial = 1e3 * row[0];
          tests.emplace_back(law,
                             axial,
                             axial * (1. - std::sin(33.1 * M_PI / 180.)),
                             row[1]);
          name = test_name;
          ++n_tests;
        }
      ElementDriver<VonWolffersdorff> &test = tests.back();
      while (test.axial_stress() < 1e3 * row[2])
        test.compress_confined(1e-5);
      largest = std::max(largest, std::abs(test.void_ratio() - row[3]));
    }
  EXPECT_EQ(n_tests, 9u);
  std::cout << "largest difference of void ratio " << largest << std::endl;
  EXPECT_LT(largest, 0.008);
}



TEST(VonWolffersdorff, measured_triaxial_tests)
{
  const VonWolffersdorff law{MaterialConstants{}};
  std::string            name;
  unsigned int           n_tests = 0;
  for (const auto &[test_name, row] :
       read_data("karlsruhe-fine-sand-drained-triaxial.csv"))
    {
      if (test_name == name)
        continue;
      name = test_name;
      ++n_tests;
      ElementDriver<VonWolffersdorff> test(law,
                                           1e3 * row[0],
                                           1e3 * row[0],
                                           row[1]);
      double                          peak = 0.;
      for (unsigned int i = 0; i < 3000; ++i)
        {
          test.compress_triaxial(1e-4);
          peak = std::max(peak, test.deviatoric_stress());
        }
      std::cout << name << ": e " << row[1] << ", peak of q "
                << peak / (1e3 * row[2]) << " of the measured one" << std::endl;
      EXPECT_NEAR(peak / (1e3 * row[2]), 1., 0.17) << name;
    }
  EXPECT_EQ(n_tests, 19u);
}
