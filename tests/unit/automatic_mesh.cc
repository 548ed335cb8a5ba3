#include <sandglass/base/exceptions.h>
#include <sandglass/scene/automatic_mesh.h>
#include <sandglass/scene/make_mesh.h>
#include <sandglass/scene/mesh_outlet.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "random_engine.h"
#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  class AutomaticMesh : public testing::Test
  {
  protected:
    /// Any silo that the parameters allow.
    void
    draw_silo(std::mt19937 &random)
    {
      const auto between = [&random](const double lower, const double upper) {
        return std::uniform_real_distribution<double>(lower, upper)(random);
      };
      const bool is_hopper   = between(0., 1.) < 0.5;
      silo.half_width        = std::pow(10., between(-2., 1.));
      silo.outlet_half_width = silo.half_width * between(0.02, 0.9);
      silo.wall_height   = silo.half_width * std::pow(10., between(-1.3, 1.3));
      silo.hopper_height = is_hopper ? silo.half_width * between(0.05, 3.) : 0.;
      silo.cell_type =
        between(0., 1.) < 0.5 ? CellType::triangle : CellType::quadrilateral;
      silo.is_symmetric = between(0., 1.) < 0.7;
      silo.formulation  = silo.is_symmetric && between(0., 1.) < 0.5 ?
                            Formulation::axisymmetric :
                            Formulation::plane_strain;
      silo.outlet_eccentricity =
        silo.is_symmetric ?
          0. :
          (silo.half_width - silo.outlet_half_width) * between(-0.9, 0.9);
    }

    /// What deserves attention in the mesh of the silo.
    std::vector<std::string>
    doubts()
    {
      std::vector<std::string> warnings;
      doubt_outlet<2>(silo, mesh_silo<2>(silo), warnings);
      return warnings;
    }

    ClearedParameters cleared;
    SceneParameters   silo;
  };



  void
  expect_equal(const Resolution &a, const Resolution &b)
  {
    EXPECT_EQ(a.element_size, b.element_size);
    EXPECT_EQ(a.outlet_element_size, b.outlet_element_size);
    EXPECT_EQ(a.particles_per_cell, b.particles_per_cell);
  }
} // namespace



TEST_F(AutomaticMesh, FitsEverySilo)
{
  std::mt19937 random = random_engine();
  for (unsigned int i = 0; i < 1000; ++i)
    {
      draw_silo(random);
      EXPECT_NO_THROW(silo.check()) << "silo " << i;
      const Resolution resolution = silo.resolution();
      // Edges across half of the outlet, if they didn't grow.
      EXPECT_GE(silo.outlet_half_width / resolution.smallest_size(), 1.9);
      EXPECT_LE(resolution.smallest_size(), resolution.element_size);
      EXPECT_EQ(resolution.particles_per_cell, 9);
      if (silo.cell_type == CellType::triangle)
        {
          EXPECT_GE(silo.outlet_half_width / resolution.smallest_size(), 7.9);
          EXPECT_GE(silo.half_width / resolution.element_size, 9.9);
          EXPECT_GE(silo.wall_height / resolution.element_size, 3.9);
        }
    }
}



/// Lengths twice as large give cells twice as large, up to the three digits.
TEST_F(AutomaticMesh, GoesWithTheSilo)
{
  std::mt19937 random = random_engine();
  for (unsigned int i = 0; i < 100; ++i)
    {
      draw_silo(random);
      const Resolution small = silo.resolution();
      for (double *length : {&silo.half_width,
                             &silo.outlet_half_width,
                             &silo.wall_height,
                             &silo.hopper_height,
                             &silo.outlet_eccentricity})
        *length *= 2.;
      const Resolution large = silo.resolution();
      EXPECT_NEAR(large.element_size / small.element_size, 2., 0.02);
      EXPECT_NEAR(large.smallest_size() / small.smallest_size(), 2., 0.02);
    }
}



TEST_F(AutomaticMesh, IsTheMeshOfItsNumbers)
{
  std::mt19937 random = random_engine();
  for (unsigned int i = 0; i < 100; ++i)
    {
      silo.element_size.reset();
      silo.outlet_element_size.reset();
      silo.particles_per_cell.reset();
      draw_silo(random);
      silo.refinement             = 1.4;
      const Resolution resolution = silo.resolution();
      silo.fix_resolution(0.);
      ASSERT_TRUE(silo.element_size && silo.outlet_element_size &&
                  silo.particles_per_cell);
      expect_equal(silo.resolution(), resolution);
    }
}



/// Hoppers flatter than 45 degrees have 16 cells along them, as far as the work
/// allows.
TEST_F(AutomaticMesh, FollowsFlatHoppers)
{
  const auto cells_along = [this](const double slope, const double wave_speed) {
    const double run   = silo.half_width - silo.outlet_half_width;
    silo.hopper_height = run * std::tan(slope * dealii::numbers::PI / 180.);
    return std::hypot(run, silo.hopper_height) /
           automatic_resolution(silo, wave_speed).element_size;
  };
  EXPECT_NEAR(cells_along(30., 0.), 16., 0.1);
  EXPECT_NEAR(cells_along(44., 20.), 16., 0.1);
  EXPECT_LT(cells_along(46., 0.), 11.);
  EXPECT_LT(cells_along(30., 1e4), 9.);
}



TEST_F(AutomaticMesh, LeavesGivenNumbersAsTheyAre)
{
  silo.element_size = 0.1;
  expect_equal(silo.resolution(), {0.1, 0., 4});
  silo.refinement = 2.;
  expect_equal(silo.resolution(), {0.05, 0., 4});
  silo.refinement          = 1.;
  silo.outlet_element_size = 0.02;
  silo.particles_per_cell  = 16;
  expect_equal(silo.resolution(), {0.1, 0.02, 16});
  silo.element_size.reset();
  expect_equal(silo.resolution(), {0.08, 0.02, 16});
  // 0 is the same size everywhere, here that which suits the outlet.
  silo.outlet_element_size = 0.;
  expect_equal(silo.resolution(), {0.0281, 0., 16});
}



TEST_F(AutomaticMesh, KnowsOnlyTheParticlesOfAMeshFile)
{
  silo.shape = SceneParameters::Shape::mesh_file;
  EXPECT_TRUE(std::isnan(silo.resolution().element_size));
  EXPECT_EQ(silo.resolution().particles_per_cell, 9);
  silo.element_size = 0.1;
  EXPECT_TRUE(std::isnan(silo.resolution().element_size));
  EXPECT_EQ(silo.resolution().particles_per_cell, 4);
}



TEST_F(AutomaticMesh, HasItsCellsAtTheLip)
{
  for (const bool is_symmetric : {true, false})
    {
      silo.is_symmetric  = is_symmetric;
      const auto outlets = mesh_outlets(mesh_silo<2>(silo));
      ASSERT_EQ(outlets.size(), 1);
      EXPECT_NEAR(outlets[0].width, 0.45, 1e-12);
      EXPECT_NEAR(outlets[0].n_cells(), 16., 2.);
      EXPECT_TRUE(doubts().empty());
    }
}



TEST_F(AutomaticMesh, DoubtsCoarseOutlets)
{
  silo.cell_type         = CellType::quadrilateral;
  silo.outlet_half_width = 0.2;
  silo.element_size      = 0.1;
  ASSERT_EQ(doubts().size(), 1);
  EXPECT_NE(doubts()[0].find("only 4 cells wide"), std::string::npos);
  EXPECT_NE(doubts()[0].find(" %, mostly too low"), std::string::npos);
  EXPECT_NE(doubts()[0].find("Element size = 0.025 or less"),
            std::string::npos);

  silo.formulation  = Formulation::axisymmetric;
  silo.element_size = 0.2;
  silo.cell_type    = CellType::triangle;
  ASSERT_EQ(doubts().size(), 1);
  EXPECT_NE(doubts()[0].find("only 2 cells wide"), std::string::npos);
  EXPECT_NE(doubts()[0].find("by some 50 %,"), std::string::npos);
  EXPECT_NE(doubts()[0].find("Outlet element size = 0.025 or less"),
            std::string::npos);

  // The same mesh by a refinement that the user may have forgotten.
  silo.element_size = 0.1;
  silo.refinement   = 0.5;
  ASSERT_EQ(doubts().size(), 1);
  EXPECT_NE(doubts()[0].find("Scene/Refinement = 4 or more"),
            std::string::npos);
  silo.refinement = 1.;

  silo.element_size   = 0.2;
  silo.outlet_is_open = false;
  EXPECT_TRUE(doubts().empty());
  silo.outlet_is_open = true;
  silo.element_size   = 0.05;
  EXPECT_TRUE(doubts().empty());
}



TEST_F(AutomaticMesh, DoubtsMeshFilesInTheirOwnWords)
{
  silo.cell_type           = CellType::quadrilateral;
  silo.is_symmetric        = false;
  silo.outlet_half_width   = 0.2;
  silo.outlet_eccentricity = 0.2;
  silo.element_size        = 0.1;
  const Mesh<2> mesh       = mesh_silo<2>(silo);
  silo.shape               = SceneParameters::Shape::mesh_file;
  std::vector<std::string> warnings;
  doubt_outlet<2>(silo, mesh, warnings);
  ASSERT_EQ(warnings.size(), 1);
  EXPECT_NE(warnings[0].find("only 4 cells wide"), std::string::npos);
  EXPECT_NE(warnings[0].find("at most 0.025 m large"), std::string::npos);
}
