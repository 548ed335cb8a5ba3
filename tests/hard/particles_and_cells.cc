#include <sandglass/scene/headroom.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "small_silo.h"

using namespace Sandglass;

namespace
{
  class ParticlesAndCells : public testing::TestWithParam<CellType>
  {
  protected:
    ParticlesAndCells()
    {
      silo.scene.cell_type = GetParam();
    }

    void
    expect_sound_flow_until(const double time, const double discharged)
    {
      silo.expect_sound_flow_until(time);
      EXPECT_GE(silo.discharged_share(), discharged);
    }

    /// Whether an edge of the cell lies on the axis.
    bool
    touches_axis(const unsigned int cell) const
    {
      const Mesh<2> &mesh = silo.fixture.scene->mesh;
      unsigned int   n    = 0;
      for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
        if (mesh.vertices[mesh.cells[cell].vertices[v]][0] < 1e-9)
          ++n;
      return n == 2;
    }

    double
    radius_of(const unsigned int cell, const Point<2> &reference) const
    {
      const Scene<2> &scene = *silo.fixture.scene;
      for (const auto &candidate : scene.triangulation.active_cell_iterators())
        if (candidate->active_cell_index() == cell)
          return scene.mapping.transform_unit_to_real_cell(candidate,
                                                           reference)[0];
      return 0.;
    }

    SmallSilo silo;
  };
} // namespace



// The particle nearest to the axis in each cell there is put nearly onto it;
// the hoop strain divides by its radius. Without the smallest distance that a
// particle keeps from its cell's edges the last one has no radius.
TEST_P(ParticlesAndCells, AtTheAxisOfRevolution)
{
  for (const double radius : {1e-3, 1e-6, 1e-9, 1e-12, 0.})
    {
      silo.scene.formulation = Formulation::axisymmetric;
      silo.start();
      const double            h = *silo.scene.element_size;
      std::map<unsigned, int> n_moved;
      silo.fixture.stage->start_from(
        [&](const unsigned int cell, const Point<2> &reference) {
          InitialState<2> state{{}, SymmetricComponents<4>::Zero(), 1.};
          const double    x = radius_of(cell, reference);
          if (touches_axis(cell) && x < 0.3 * h && n_moved[cell]++ == 0)
            state.displacement[0] = radius * h - x;
          return state;
        },
        {});
      std::cout << "radius / cell " << radius << ": ";
      expect_sound_flow_until(0.4, 0.02);
    }
}



// This and the tests below fail at four times the time step.
TEST_P(ParticlesAndCells, AnOutletOfTwoCells)
{
  for (const auto lip :
       {WallParameters::OutletLip::floor, WallParameters::OutletLip::free})
    for (const bool is_symmetric : {true, false})
      {
        silo.fixture.walls.outlet_lip = lip;
        silo.scene.is_symmetric       = is_symmetric;
        silo.scene.outlet_half_width  = *silo.scene.element_size;
        silo.start();
        expect_sound_flow_until(1., 0.);
      }
}



// Flat triangles are left out: material heaves there, and the grid ends at the
// silo's top.
TEST_P(ParticlesAndCells, CellsOfExtremeAspectRatio)
{
  for (const double factor : {0.05, 0.2, 5., 20.})
    {
      if (factor > 1. && GetParam() == CellType::triangle)
        continue;
      Mesh<2> mesh = mesh_silo<2>(silo.scene);
      for (auto &vertex : mesh.vertices)
        vertex[0] *= factor;
      // Between cells twenty times as wide as high the surface heaves beside
      // what falls.
      add_headroom(mesh, 0.1);
      silo.start(mesh);
      std::cout << "cells 1 : " << factor << ": ";
      expect_sound_flow_until(0.4, 0.);
    }
}



TEST_P(ParticlesAndCells, OneAndSixtyFourPerCell)
{
  for (const unsigned int n : {1u, 4u, 16u, 64u})
    {
      silo.scene.particles_per_cell = n;
      silo.start();
      std::cout << n << " particles per cell: ";
      expect_sound_flow_until(0.4, 0.05);
    }
}



TEST_P(ParticlesAndCells, DischargeToTheLastParticle)
{
  silo.scene.hopper_height          = 0.4;
  silo.fixture.walls.friction_angle = 10.;
  silo.start();
  const auto &cloud = silo.fixture.stage->particles();
  while (cloud.n_locally_owned_particles() > 0 &&
         silo.fixture.stage->view().clock().time < 20.)
    silo.fixture.stage->step();
  std::cout << cloud.n_locally_owned_particles() << " particles left at "
            << silo.fixture.stage->view().clock().time << " s" << std::endl;
  EXPECT_EQ(cloud.n_locally_owned_particles(), 0u);
  EXPECT_NEAR(silo.discharged_share(), 1., 1e-12);
  // Nothing is left to compute, but the clock goes on.
  const double time = silo.fixture.stage->view().clock().time;
  for (unsigned int step = 0; step < 100; ++step)
    silo.fixture.stage->step();
  EXPECT_GT(silo.fixture.stage->view().clock().time, time);
  EXPECT_TRUE(std::isfinite(silo.fixture.stage->view().clock().time));
}

INSTANTIATE_TEST_SUITE_P(CellTypes,
                         ParticlesAndCells,
                         testing::Values(CellType::triangle,
                                         CellType::quadrilateral));
